# Writes OUTPUT, a C++ file that holds every file below FOLDER as a raw string, for lib/gl/shader_source.cpp.
file(GLOB_RECURSE names RELATIVE ${FOLDER} ${FOLDER}/*)
list(FILTER names EXCLUDE REGEX "(^|/)\\.")  # such as .clang-format
list(SORT names)
set(text "#include \"gl/shader_source.h\"\n\nnamespace candela::gl {\n\nstd::span<const EmbeddedShader> embeddedShaders() {\n    static const EmbeddedShader shaders[] = {\n")
foreach(name IN LISTS names)
  file(READ ${FOLDER}/${name} body)
  string(APPEND text "        {\"${name}\", R\"shader(${body})shader\"},\n")
endforeach()
string(APPEND text "    };\n    return shaders;\n}\n\n}  // namespace candela::gl\n")
file(WRITE ${OUTPUT} "${text}")
