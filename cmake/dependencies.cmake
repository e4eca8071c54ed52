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
# Debian's CMake package of OpenSubdiv names static libraries that Debian does not have.
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/bfr/surface.h REQUIRED)
find_library(OPENSUBDIV_LIBRARY osdCPU REQUIRED)
add_library(OpenSubdiv::osdCPU SHARED IMPORTED)
set_target_properties(OpenSubdiv::osdCPU PROPERTIES
  IMPORTED_LOCATION ${OPENSUBDIV_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${OPENSUBDIV_INCLUDE_DIR})
find_package(glfw3 3.3 REQUIRED)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui>=1.86)

if(CANDELA_TESTS)
  find_package(GTest 1.12 REQUIRED)
endif()
