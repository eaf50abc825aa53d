# Compiles and runs by_rust.rs: -DRUSTC= -DLIBRARY= -DSOURCE= -DWORK=.
if(NOT RUSTC)
  message("skipped: rustc is not here (Debian's rustc)")
  return()
endif()
get_filename_component(folder ${LIBRARY} DIRECTORY)
execute_process(COMMAND ${RUSTC} --edition 2021 -D warnings -L ${folder} -C link-arg=-Wl,-rpath,${folder} -o ${WORK}/by_rust
  ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/by_rust COMMAND_ERROR_IS_FATAL ANY)
