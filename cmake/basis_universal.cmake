# The transcoder of Basis Universal, with which KTX2 images are decoded, as the target basis_universal. Debian 12 has no package of it:
# its source comes from the registry crates.io, whose package basis-universal-sys carries it unchanged, or from a folder. Sets
# CANDELA_HAS_KTX2; without the source candela is built without KTX2.

set(CANDELA_BASIS_UNIVERSAL_DIR "" CACHE PATH "Folder with the source of Basis Universal 1.50; empty: it is downloaded")
set(CANDELA_HAS_KTX2 FALSE)
if(NOT CANDELA_KTX2)
  return()
endif()

set(basis_universal_dir ${CANDELA_BASIS_UNIVERSAL_DIR})
if(NOT basis_universal_dir)
  set(basis_universal_crate basis-universal-sys-0.3.1)
  set(basis_universal_dir ${PROJECT_BINARY_DIR}/${basis_universal_crate}/vendor/basis_universal)
  if(NOT EXISTS ${basis_universal_dir})
    set(basis_universal_archive ${PROJECT_BINARY_DIR}/${basis_universal_crate}.tar.gz)
    file(DOWNLOAD https://static.crates.io/crates/basis-universal-sys/${basis_universal_crate}.crate ${basis_universal_archive}
      EXPECTED_HASH SHA256=fd9bde5e9547958fb0e77d79fc7879edcf91d5e0c8e372ef8959916cf35e8506
      INACTIVITY_TIMEOUT 30 STATUS basis_universal_status)
    list(POP_FRONT basis_universal_status basis_universal_code)
    if(basis_universal_code EQUAL 0)
      file(ARCHIVE_EXTRACT INPUT ${basis_universal_archive} DESTINATION ${PROJECT_BINARY_DIR})
    endif()
    file(REMOVE ${basis_universal_archive})
  endif()
endif()
if(NOT EXISTS ${basis_universal_dir}/transcoder/basisu_transcoder.cpp)
  message(WARNING "KTX2 images will not be read: the source of Basis Universal is not there (${basis_universal_status})")
  return()
endif()

pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd>=1.4)
add_library(basis_universal STATIC ${basis_universal_dir}/transcoder/basisu_transcoder.cpp)
target_link_libraries(basis_universal PRIVATE PkgConfig::zstd)
target_include_directories(basis_universal SYSTEM PUBLIC ${basis_universal_dir}/transcoder)
# Textures become RGBA: no other target format is needed.
target_compile_definitions(basis_universal PRIVATE
  BASISD_SUPPORT_KTX2=1 BASISD_SUPPORT_KTX2_ZSTD=1 BASISD_SUPPORT_DXT1=0 BASISD_SUPPORT_DXT5A=0 BASISD_SUPPORT_BC7_MODE5=0
  BASISD_SUPPORT_PVRTC1=0 BASISD_SUPPORT_ETC2_EAC_A8=0 BASISD_SUPPORT_ASTC=0 BASISD_SUPPORT_ATC=0
  BASISD_SUPPORT_ETC2_EAC_RG11=0 BASISD_SUPPORT_FXT1=0 BASISD_SUPPORT_PVRTC2=0)
target_compile_options(basis_universal PRIVATE -w -fno-strict-aliasing)
set_target_properties(basis_universal PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
set(CANDELA_HAS_KTX2 TRUE)
