# Parsing the standard library, GLM and GoogleTest takes most of the time that a source file takes to compile, so they are
# compiled once: `candela_pch_library` for libraries, plugins and programs, `candela_pch_test` for tests. Both hold system
# headers only, so that no change in this tree compiles everything again. Every file still includes what it uses: a build
# with CANDELA_PRECOMPILED_HEADERS=OFF, such as the preset `dev`, compiles each alone.

set(candela_std_headers
  <algorithm> <array> <cassert> <cmath> <cstddef> <cstdint> <cstring> <filesystem> <functional> <limits> <map> <memory>
  <mutex> <numbers> <numeric> <optional> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
set(candela_glm_headers
  <glm/common.hpp> <glm/geometric.hpp> <glm/gtc/quaternion.hpp> <glm/mat3x3.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp>
  <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp>)

# candela_precompiled_headers(KIND HEADERS...) declares the target candela_pch_KIND.
function(candela_precompiled_headers kind)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp CONTENT "")
  add_library(candela_pch_${kind} OBJECT ${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp)
  target_precompile_headers(candela_pch_${kind} PRIVATE ${ARGN})
  target_include_directories(candela_pch_${kind} SYSTEM PRIVATE ${GLM_INCLUDE_DIR})
  target_link_libraries(candela_pch_${kind} PRIVATE candela_options)
endfunction()

# candela_use_precompiled_headers(TARGET KIND) compiles TARGET with the headers of candela_pch_KIND.
function(candela_use_precompiled_headers target kind)
  if(NOT CANDELA_PRECOMPILED_HEADERS)
    return()
  endif()
  target_precompile_headers(${target} REUSE_FROM candela_pch_${kind})
  get_target_property(type ${target} TYPE)
  if(type STREQUAL EXECUTABLE)
    # As in libraries: one precompiled header serves -fPIC or -fPIE, not both.
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fPIC>)
  endif()
endfunction()

# Tests are compiled with few optimisations, and none where sanitizers instrument them: they take long to optimise, and
# what they call is optimised.
set(candela_test_optimisation $<$<CONFIG:Release>:-O1>$<$<CONFIG:Debug>:-O0>)

# candela_compile_as_test(TARGET) compiles TARGET with the precompiled headers of tests.
function(candela_compile_as_test target)
  target_compile_options(${target} PRIVATE ${candela_test_optimisation})
  candela_use_precompiled_headers(${target} test)
endfunction()

if(CANDELA_PRECOMPILED_HEADERS)
  candela_precompiled_headers(library ${candela_std_headers} ${candela_glm_headers})
  if(CANDELA_TESTS)
    candela_precompiled_headers(test
      <gtest/gtest.h> <fstream> <random> ${candela_std_headers} ${candela_glm_headers} <glm/gtc/matrix_transform.hpp>)
    target_link_libraries(candela_pch_test PRIVATE GTest::gtest)
    target_compile_options(candela_pch_test PRIVATE ${candela_test_optimisation})
  endif()
endif()
