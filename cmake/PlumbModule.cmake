# plumb_module(<name> HEADERS ... [SOURCES ...] [USES <module>...] [PRIVATE <target>...]
#           [PUBLIC <target>...])
#
# Adds the library plumb::<name> from the folder <name>. USES lists the modules below it that its
# files may include. A third-party library goes under PRIVATE (its headers appear in .cpp files
# only) unless a public header needs it. An installed plumb offers the same target
# (find_package(plumb), cmake/PlumbInstall.cmake). Every header must compile on its own: the target
# all_verify_interface_header_sets does that, and the tests build it.
function(plumb_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES;USES;PUBLIC;PRIVATE")
  list(TRANSFORM arg_USES PREPEND plumb::)
  if(arg_SOURCES)
    set(scope PUBLIC)
    add_library(plumb_${name} STATIC ${arg_SOURCES})
    plumb_warnings(plumb_${name})
  else()
    set(scope INTERFACE)
    add_library(plumb_${name} INTERFACE)
  endif()
  add_library(plumb::${name} ALIAS plumb_${name})
  target_sources(plumb_${name} ${scope} FILE_SET HEADERS
                 BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  target_compile_features(plumb_${name} ${scope} cxx_std_20)
  target_link_libraries(plumb_${name} ${scope} ${arg_USES} ${arg_PUBLIC})
  if(arg_PRIVATE)
    target_link_libraries(plumb_${name} PRIVATE ${arg_PRIVATE})
  endif()
  set_target_properties(plumb_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON EXPORT_NAME ${name})
  install(TARGETS plumb_${name} EXPORT plumbTargets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb)
endfunction()

# plumb_test(<name> SOURCES ... USES <module>... [PRIVATE <target>...])
#
# Adds the test program <name>_test from tests/<name>/ and hands its cases to CTest. A test program
# may use any module that it names: the include order binds the modules, not their tests.
function(plumb_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;USES;PRIVATE")
  list(TRANSFORM arg_USES PREPEND plumb::)
  add_executable(${name}_test ${arg_SOURCES})
  plumb_warnings(${name}_test)
  target_include_directories(${name}_test PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name}_test PRIVATE
    PLUMB_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PLUMB_BINARY_DIR="${PROJECT_BINARY_DIR}")
  target_link_libraries(${name}_test PRIVATE ${arg_USES} ${arg_PRIVATE} GTest::gmock GTest::gtest_main)
  gtest_discover_tests(${name}_test DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()

# The warnings that every target of ours is compiled with; errors where PLUMB_WERROR is on.
# -Wno-restrict: g++ 12 sees overlaps in every "text" + std::string (GCC bug 105651).
# -Wno-maybe-uninitialized: under sanitizers g++ 12 sees it in the standard library (105562).
function(plumb_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
                         -Wno-sign-conversion -Wno-restrict
                         $<$<BOOL:${PLUMB_SANITIZE}>:-Wno-maybe-uninitialized>
                         $<$<BOOL:${PLUMB_WERROR}>:-Werror>)
endfunction()
