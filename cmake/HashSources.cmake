cmake_minimum_required(VERSION 3.25)
# Writes OUT, a C++ source that knows the SHA-256 of "path hash\n" of all FILES, in their order:
# cmake -DROOT=... -DFILES="a.h;b.cpp" -DOUT=... -P HashSources.cmake
set(text "")
foreach(file IN LISTS FILES)
  file(SHA256 ${ROOT}/${file} hash)
  string(APPEND text "${file} ${hash}\n")
endforeach()
string(SHA256 all "${text}")
file(CONFIGURE OUTPUT ${OUT} CONTENT "#include \"jobs/truth/sources_hash.h\"

namespace plumb {

const char* TruthSourcesHash() {
    return \"@all@\";
}

}  // namespace plumb
" @ONLY)
