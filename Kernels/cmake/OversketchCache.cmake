# What ccache has to know of this tree, said here and not in the user's own settings. Paths in it count from the build folder, so that
# a clone in another folder finds what this one has compiled. It looks at what the preprocessor makes, since the files of a unity
# build name their sources by whole paths; with a precompiled header that is short.
if (CMAKE_CXX_COMPILER_LAUNCHER STREQUAL "ccache")
  set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_SLOPPINESS=pch_defines,time_macros ccache)
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
  execute_process(COMMAND ccache --get-config cache_dir OUTPUT_VARIABLE oversketch_ccache OUTPUT_STRIP_TRAILING_WHITESPACE)
endif ()

# oversketch_init_by_name(): makes all targets include by its name what VTK writes for its factories. The compiler's cache takes its whole
# path for part of the source. To be called when all targets are there.
function (oversketch_init_by_name)
  set(folders "${PROJECT_SOURCE_DIR}")
  while (folders)
    list(POP_FRONT folders folder)
    get_property(further DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
    list(APPEND folders ${further})
    get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
    foreach (target IN LISTS targets)
      get_property(definitions TARGET ${target} PROPERTY COMPILE_DEFINITIONS)
      if (definitions MATCHES "_AUTOINIT_INCLUDE=")
        string(REPLACE "${CMAKE_BINARY_DIR}/CMakeFiles/" "" definitions "${definitions}")
        set_property(TARGET ${target} PROPERTY COMPILE_DEFINITIONS "${definitions}")
        set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES "${CMAKE_BINARY_DIR}/CMakeFiles")
      endif ()
    endforeach ()
  endwhile ()
endfunction ()
