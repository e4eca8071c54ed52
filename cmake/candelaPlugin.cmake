# candela_add_plugin(NAME SOURCES...) declares the plugin NAME: a module NAME.so that sees candela/plugin.h, exports its
# entry point alone and does not link candela. candela finds it in a folder given by --plugin-path, by the environment
# variable CANDELA_PLUGIN_PATH or by PluginRegistry, and in candela_PLUGIN_DIR, to which `install` may put it:
#
#     candela_add_plugin(triangles triangle_importer.cpp)
#     install(TARGETS triangles LIBRARY DESTINATION ${candela_PLUGIN_DIR})
function(candela_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${name} SYSTEM PRIVATE
    $<TARGET_PROPERTY:candela::candela,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
