# `cmake --install`: headers, the shared library, plugins (declared in plugins/), the programs with man pages and completions, and what lets other
# projects find them: a CMake package and a pkg-config file. The tree can be moved after installation. Components are `library` (with
# plugins), `development`, `tools` and `python`; package.cmake makes packages of them.

# GLM is the vocabulary of the public headers, so targets that link candela need it too.
target_link_libraries(candela INTERFACE $<INSTALL_INTERFACE:glm::glm>)

install(TARGETS candela EXPORT candelaTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT library NAMELINK_COMPONENT development)
foreach(program candela-render candela-view candela-bench)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
    get_target_property(texts ${program} CANDELA_TEXTS)
    if(texts)
      install(FILES ${texts}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
      install(FILES ${texts}.bash RENAME ${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        COMPONENT tools)
      install(FILES ${texts}.zsh RENAME _${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
        COMPONENT tools)
      install(FILES ${texts}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tools)
    endif()
  endif()
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/candela ${PROJECT_BINARY_DIR}/include/candela
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")

if(CANDELA_HAS_PYTHON AND CANDELA_PYTHON_INSTALL_DIR)
  install(TARGETS candela_python LIBRARY DESTINATION ${CANDELA_PYTHON_INSTALL_DIR}/candela COMPONENT python)
  install(FILES ${PROJECT_BINARY_DIR}/python/candela/_candela.pyi
    DESTINATION ${CANDELA_PYTHON_INSTALL_DIR}/candela COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/candela DESTINATION ${CANDELA_PYTHON_INSTALL_DIR} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()

set(candela_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/candela)
install(EXPORT candelaTargets NAMESPACE candela:: DESTINATION ${candela_package_dir} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/candelaConfig.cmake.in ${PROJECT_BINARY_DIR}/candelaConfig.cmake
  INSTALL_DESTINATION ${candela_package_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may break what was built with an older one.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/candelaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/candelaConfig.cmake ${PROJECT_BINARY_DIR}/candelaConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/candelaPlugin.cmake
  DESTINATION ${candela_package_dir} COMPONENT development)

file(RELATIVE_PATH candela_prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${PROJECT_SOURCE_DIR}/cmake/candela.pc.in ${PROJECT_BINARY_DIR}/candela.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/candela.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development
  PATTERN site EXCLUDE)
