# `cpack` makes Debian packages of a build of the preset `package`: the library with its plugins, what compiles against it, the
# programs, and the module for Debian's Python, where that is built (python.cmake). Components are those of install.cmake.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME candela)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # Each package has a summary of its own.
set(CPACK_PACKAGE_VENDOR "The candela authors")
set(CPACK_PACKAGE_CONTACT "The candela authors <candela@users.noreply.github.com>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/compress_man_pages.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL library development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(candela_library_package libcandela${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(candela_summary "renderer of scenes lit by very many point lights")

# candela_package(COMPONENT PACKAGE SECTION SUMMARY TEXT) declares a package, with its copyright file and changelog.
function(candela_package component package section summary text)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/${package})
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright DESTINATION ${folder} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${folder} COMPONENT ${component})
endfunction()

string(TIMESTAMP candela_date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, where it is set
configure_file(${PROJECT_SOURCE_DIR}/packaging/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)

candela_package(library ${candela_library_package} libs "${candela_summary} - library"
  "A renderer on OpenGL 4.5 with physically based shading and a shadow of
every light, for windows, servers with a GPU, and machines without one.
This package has the library and its plugins, which read glTF, Wavefront
OBJ and subdivision surfaces.")
candela_package(development libcandela-dev libdevel "${candela_summary} - development files"
  "Headers, a CMake package, a pkg-config file and the documentation of candela.")
file(WRITE ${PROJECT_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/triggers)
# libepoxy opens these by name.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "libegl-mesa0, libgl1-mesa-dri")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${candela_library_package} (= ${PROJECT_VERSION}), libglm-dev")

if(CANDELA_BUILD_RENDER)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${candela_library_package} (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "fonts-dejavu-core")
  list(APPEND CPACK_COMPONENTS_ALL tools)
  candela_package(tools candela-tools graphics "${candela_summary} - programs"
    "candela-render draws pictures and sequences without a window,
candela-view shows scenes, and candela-bench measures rendering with
many lights.")
endif()

if(CANDELA_HAS_PYTHON AND CANDELA_PYTHON_INSTALL_DIR)
  list(APPEND CPACK_COMPONENTS_ALL python)
  candela_package(python python3-candela python "${candela_summary} - Python module"
    "Draws pictures of scenes from files and NumPy arrays, and reads radiance,
depth, normals and the like back as arrays.")
  # The module is for this minor version of Python alone.
  math(EXPR candela_next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${candela_library_package} (= ${PROJECT_VERSION}), python3-numpy, \
python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${candela_next_python})")
  # Compile the files when the package is installed, and remove what was compiled before it is removed.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packaging/python/postinst ${PROJECT_SOURCE_DIR}/packaging/python/prerm)
endif()

include(CPack)
