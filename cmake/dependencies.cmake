# Every library that candela uses, with the least version it works with. Included by the top folder, so that all folders see them.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(PNG 1.6 REQUIRED)
find_package(JPEG REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
# Debian puts the CMake packages of OpenEXR and OpenColorIO where CMake cannot use them; their pkg-config files work.
pkg_check_modules(openexr REQUIRED IMPORTED_TARGET OpenEXR>=3.1)
pkg_check_modules(opencolorio REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy>=1.5)
find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)

if(CANDELA_TESTS)
  find_package(GTest 1.12 REQUIRED)
endif()
