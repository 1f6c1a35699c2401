# What ccache has to know of this tree, said here and not in the user's own settings. Paths in it count from the build folder, so that
# a clone in another folder finds what this one has compiled. It looks at what the preprocessor makes, since the files of a unity
# build name their sources by whole paths; with a precompiled header that is short.
if (CMAKE_CXX_COMPILER_LAUNCHER STREQUAL "ccache")
  set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_SLOPPINESS=pch_defines,time_macros ccache)
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
  execute_process(COMMAND ccache --get-config cache_dir OUTPUT_VARIABLE oversketch_ccache OUTPUT_STRIP_TRAILING_WHITESPACE)
endif ()
