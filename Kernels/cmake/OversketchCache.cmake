# What ccache has to know of this tree, said here and not in the user's own settings. Paths in it count from the build folder, so
# that a source which a second build compiles in the same way (the packages', the wheel's, the kernels of the ParaView plugin) is
# found in the cache; and it takes the compiler's own list of included files, which spares a run of the preprocessor.
if (CMAKE_CXX_COMPILER_LAUNCHER STREQUAL "ccache")
  set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_DEPEND=1 ccache)
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
  execute_process(COMMAND ccache --get-config cache_dir OUTPUT_VARIABLE oversketch_ccache OUTPUT_STRIP_TRAILING_WHITESPACE)
endif ()
