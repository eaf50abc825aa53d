# A toolchain for arm64 by Debian's g++-aarch64-linux-gnu; what is built runs here under qemu-user (preset 'arm64').
#
# Libraries and headers come from Debian's arm64 packages, which `./bootstrap arm64` unpacks below build/arm64-packages
# and does not install: a package must have the same version for two architectures, so that this machine's would change.
# Programs are linked statically and ask for no loader of arm64.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
if(NOT CMAKE_CXX_COMPILER)  # or -DCMAKE_CXX_COMPILER=clang++-14, which needs the other's headers and libraries as well
  set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
endif()
set(CMAKE_CXX_COMPILER_TARGET aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)

set(packages ${CMAKE_CURRENT_LIST_DIR}/../build/arm64-packages)
cmake_path(NORMAL_PATH packages)
set(CMAKE_FIND_ROOT_PATH ${packages} /usr/aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# Highway compiles its NEON lanes with the instructions for AES, which every function that takes them in must have too.
set(CMAKE_CXX_FLAGS_INIT "-march=armv8-a+crypto -isystem ${packages}/usr/include/aarch64-linux-gnu")
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
