# Every library that candela uses, with the minimum version it works with, looked for where an option needs it. Included by
# the top folder, so that all folders see them.

find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(PNG 1.6 REQUIRED)
# Debian puts the CMake packages of OpenEXR and OpenColorIO where CMake cannot use them; their pkg-config files work.
pkg_check_modules(openexr REQUIRED IMPORTED_TARGET OpenEXR>=3.1)
pkg_check_modules(opencolorio REQUIRED IMPORTED_TARGET OpenColorIO>=2.1)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy>=1.5)
find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)

if(CANDELA_BUILD_RENDER OR CANDELA_BUILD_VIEW OR CANDELA_BUILD_BENCH)
  find_package(CLI11 2.1 REQUIRED)
endif()
if(CANDELA_BUILD_RENDER OR CANDELA_BUILD_VIEW OR CANDELA_BUILD_BENCH OR CANDELA_BUILD_PLUGINS)
  find_package(nlohmann_json 3.11 REQUIRED)
endif()
if(CANDELA_BUILD_PLUGINS)
  find_package(JPEG REQUIRED)
  find_package(TinyGLTF REQUIRED)
endif()
if(CANDELA_BUILD_PLUGINS OR CANDELA_BUILD_BENCH)
  # Debian's CMake package of OpenSubdiv names static libraries that Debian does not have.
  find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/bfr/surface.h REQUIRED)
  find_library(OPENSUBDIV_LIBRARY osdCPU REQUIRED)
  add_library(OpenSubdiv::osdCPU SHARED IMPORTED)
  set_target_properties(OpenSubdiv::osdCPU PROPERTIES
    IMPORTED_LOCATION ${OPENSUBDIV_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${OPENSUBDIV_INCLUDE_DIR})
endif()
if(CANDELA_BUILD_VIEW)
  find_package(glfw3 3.3 REQUIRED)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui>=1.86)
endif()
if(CANDELA_TESTS)
  find_package(GTest 1.12 REQUIRED)
endif()
