# Installs the build into a temporary prefix, then configures, builds and runs the consumer against it.
set(prefix "${BUILD}/Testing/Temporary/prefix")
set(work "${BUILD}/Testing/Temporary/consumer")
file(REMOVE_RECURSE "${prefix}" "${work}")
foreach (command IN ITEMS
    "${CMAKE_COMMAND};--install;${BUILD};--prefix;${prefix}"
    "${CMAKE_COMMAND};-S;${SOURCE};-B;${work};-G;${GENERATOR};-DCMAKE_PREFIX_PATH=${prefix};-DCMAKE_BUILD_TYPE=Release"
    "${CMAKE_COMMAND};--build;${work}"
    "${work}/consumer")
  execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
  if (result)
    message(FATAL_ERROR "${command}: ${result}\n${error}")
  endif ()
endforeach ()
