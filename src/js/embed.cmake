# Writes a module of JavaScript that holds a file: so that one import loads it, from a disk, a server or a bundle.
find_program(base64 base64 REQUIRED NO_CMAKE_FIND_ROOT_PATH)
execute_process(COMMAND ${base64} -w 0 ${WASM} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${TO} "// The signs as WebAssembly, by base64; index.js loads it.\nexport default '${text}';\n")
