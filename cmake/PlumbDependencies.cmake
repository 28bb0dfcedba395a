# Everything that plumb stands on, all of it from the distribution's packages (docs/building.md).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(Ceres REQUIRED)
find_package(embree 3 REQUIRED)
find_package(hwy REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(GTest REQUIRED)

find_package(OpenImageIO REQUIRED)
# Debian's target names an OpenCV include folder that its package does not bring.
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${OpenImageIO_INCLUDE_DIR}")

find_file(PLUMB_CHART_JS chart.min.js PATHS /usr/share/javascript/chart.js REQUIRED
          DOC "Chart.js, embedded in every HTML report so that it opens offline")
