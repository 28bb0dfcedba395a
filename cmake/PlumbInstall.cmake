# What `cmake --install` lays down beside the libraries and headers of plumb_module: the files that
# find_package(plumb) reads. Targets are plumb::core, plumb::truth and so on, one a room.
include(CMakePackageConfigHelpers)

set(plumb_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)
install(EXPORT plumbTargets NAMESPACE plumb:: DESTINATION ${plumb_package_dir})
file(WRITE ${PROJECT_BINARY_DIR}/plumbConfig.cmake [[
include(${CMAKE_CURRENT_LIST_DIR}/PlumbDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/plumbTargets.cmake)
]])
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plumbConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plumbConfig.cmake
              ${PROJECT_BINARY_DIR}/plumbConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/PlumbDependencies.cmake
        DESTINATION ${plumb_package_dir})
