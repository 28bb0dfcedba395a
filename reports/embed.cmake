# Writes a C++ file that holds other files as bytes, so that a report needs nothing on the disk.
#
#   cmake -DOUTPUT=<file.cpp> -DHEADER=<header> -DFUNCTIONS=A,B -DFILES=a.js,b.css -P embed.cmake
#
# For each function A in the namespace plumb: std::string_view A(), the bytes of its file.
# Bytes, not string literals: those have a length limit in some compilers, and need escapes.
string(REPLACE "," ";" functions "${FUNCTIONS}")
string(REPLACE "," ";" files "${FILES}")
set(text "#include \"${HEADER}\"\n\nnamespace plumb {\n")
foreach(function file IN ZIP_LISTS functions files)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "(................................................................)"
         "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(APPEND text "
namespace {
const unsigned char k${function}[] = {
${bytes}};
}  // namespace

std::string_view ${function}() {
    return {reinterpret_cast<const char*>(k${function}), sizeof k${function}};
}
")
endforeach()
string(APPEND text "\n}  // namespace plumb\n")
file(WRITE "${OUTPUT}" "${text}")
