# What plumb's libraries stand on, all of it from the distribution's packages (docs/building.md).
# An installed plumb reads this file too: whoever links a static library links what it needs.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(Ceres REQUIRED)
find_package(embree 3 REQUIRED)
find_package(hwy REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(assimp REQUIRED)
find_package(TIFF REQUIRED)

find_package(OpenImageIO REQUIRED)
# Debian's target names an OpenCV include folder that its package does not bring.
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR}")
