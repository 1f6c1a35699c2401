# Warnings that our own sources must be free of. VTK's headers come in as system headers.
set(oversketch_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)
if (CMAKE_UNITY_BUILD) # names of several files meet; each by itself is what the preset plain looks at
  list(APPEND oversketch_warnings -Wno-shadow -Wno-subobject-linkage)
endif ()
if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=") # what they add makes the standard library's own expressions look uninitialised to GCC
  list(APPEND oversketch_warnings -Wno-maybe-uninitialized)
endif ()
# VTK 9.1's own macros leave a semicolon that -Wpedantic refuses.
set(oversketch_filter_warnings ${oversketch_warnings})
list(REMOVE_ITEM oversketch_filter_warnings -Wpedantic)

# oversketch_kernel(<Name> SOURCES <file>... HEADERS <file>... [PUBLIC <target>...] [PRIVATE <target>...])
# A kernel library Oversketch::Kernels<Name>: plain C++17, no VTK. Installed and exported.
function (oversketch_kernel name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE")
  set(target OversketchKernels${name})
  add_library(${target} ${arg_SOURCES} ${arg_HEADERS})
  add_library(Oversketch::Kernels${name} ALIAS ${target})
  set_property(GLOBAL APPEND PROPERTY oversketch_kernels ${name})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME Kernels${name}
    ${oversketch_versions}
    CXX_VISIBILITY_PRESET default) # kernels are small and wholly public
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/Kernels>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/Kernels>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/oversketch/Kernels>)
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  target_compile_options(${target} PRIVATE ${oversketch_warnings})
  oversketch_precompile(${target} kernels HEADERS ${oversketch_std_headers} ${oversketch_eigen_headers} LIBRARIES Eigen3::Eigen
    OPTIONS ${oversketch_warnings} POSITION_INDEPENDENT)
  install(TARGETS ${target} EXPORT Oversketch
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
  install(FILES ${arg_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/oversketch/Kernels/${name} COMPONENT development)
endfunction ()

# oversketch_embed_cl(<target> <file.cl>...): makes each OpenCL source a string of the target, at build time. Kernels/Ray/
# rays.cl becomes the constant oversketch::rays_cl in the header "Ray/rays_cl.h".
set(oversketch_embed_script "${CMAKE_CURRENT_LIST_DIR}/embed_cl.cmake")
function (oversketch_embed_cl target)
  foreach (file IN LISTS ARGN)
    cmake_path(GET file STEM name)
    set(header "${CMAKE_CURRENT_BINARY_DIR}/${name}_cl.h")
    add_custom_command(OUTPUT "${header}"
      COMMAND ${CMAKE_COMMAND} -D "input=${CMAKE_CURRENT_SOURCE_DIR}/${file}" -D "output=${header}"
        -D "name=${name}_cl" -P "${oversketch_embed_script}"
      DEPENDS "${file}" "${oversketch_embed_script}"
      COMMENT "Embedding ${file}" VERBATIM)
    target_sources(${target} PRIVATE "${header}")
  endforeach ()
endfunction ()

# OpenCL programs that PoCL compiled stay in the build tree: a test neither needs nor changes the user's own.
set(oversketch_test_caches "XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/Testing/Temporary/cache")
set(oversketch_python_caches "${oversketch_test_caches}")
if (oversketch_ccache) # those that build find there what this build has compiled
  list(APPEND oversketch_python_caches "CCACHE_DIR=${oversketch_ccache}")
endif ()

set(oversketch_test_options $<$<CONFIG:Release>:-O1>)
if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  list(APPEND oversketch_test_options -Og)
endif ()

# oversketch_test_program(<target>): a program of C++ tests. It is compiled to be compiled soon: its files together, since most of
# the time goes into the headers, and it need not be quick; under the sanitizers, where optimizing it is most of the compile time,
# no more than helps a debugger.
function (oversketch_test_program target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 8 EXCLUDE_FROM_ALL ON)
  target_compile_options(${target} PRIVATE ${oversketch_test_options} -Wno-shadow -Wno-subobject-linkage) # names of several files meet
endfunction ()

# Each program of C++ tests has one home: what links VTK, or takes minutes under the sanitizers, a release build, kernels and what is
# hostile the sanitizers. The target `tests` builds those at home, ctest runs what is labelled `home`; with OVERSKETCH_ALL_TESTS every
# program is at home in every build.
option(OVERSKETCH_ALL_TESTS "Build and run all C++ tests, those too whose home is another preset" OFF)
add_custom_target(tests)

# oversketch_at_home(<target> RELEASE|SANITIZER <test>...): the home of a program and of its tests of ctest.
function (oversketch_at_home target home)
  set(here RELEASE)
  if (CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    set(here SANITIZER)
  endif ()
  if (OVERSKETCH_ALL_TESTS OR home STREQUAL here)
    add_dependencies(tests ${target})
    set_property(TEST ${ARGN} APPEND PROPERTY LABELS home)
  endif ()
endfunction ()

# oversketch_lacks(<variable> <target>...): whether one of the targets is a module of this project that is left out, see
# OVERSKETCH_WITHOUT. Kernels never are; while their tests are made some of them are still to come.
function (oversketch_lacks variable)
  set(lacks FALSE)
  foreach (target IN LISTS ARGN)
    if (target MATCHES "^Oversketch::(Filters|Widgets)" AND NOT TARGET ${target})
      set(lacks TRUE)
    endif ()
  endforeach ()
  set(${variable} ${lacks} PARENT_SCOPE)
endfunction ()

# oversketch_gtest(<name> SOURCES <file>... LIBRARIES <target>... [DISPLAY] [RELEASE | SANITIZER] [SHARDS <number>]): one GoogleTest program, one
# test of ctest, or so many SHARDS of a long one. Tests of the specification's facts are named after stage and place:
# TEST(A3_2, ...). DISPLAY: it draws, on a virtual display. RELEASE, SANITIZER: its home, where it is not what the rule above says.
# There is none where a system that it links is left out.
function (oversketch_gtest name)
  if (NOT OVERSKETCH_BUILD_TESTING)
    return()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "DISPLAY;RELEASE;SANITIZER" "SHARDS" "SOURCES;LIBRARIES")
  oversketch_lacks(lacks ${arg_LIBRARIES})
  if (lacks)
    return()
  endif ()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/Testing)
  target_compile_options(${name} PRIVATE ${oversketch_filter_warnings})
  oversketch_test_program(${name})
  set(kind kernel_tests)
  set(headers)
  set(libraries)
  if ("${arg_LIBRARIES}" MATCHES "Oversketch::(Filters|Widgets)|oversketch_") # which bring VTK
    set(kind tests)
    set(headers ${oversketch_vtk_headers})
    set(libraries ${oversketch_vtk_targets})
  endif ()
  oversketch_precompile(${name} ${kind}
    HEADERS ${oversketch_std_headers} ${oversketch_eigen_headers} ${headers} <gtest/gtest.h>
    LIBRARIES Eigen3::Eigen ${libraries} GTest::gtest
    OPTIONS ${oversketch_test_options})
  set(run $<TARGET_FILE:${name}>)
  set(home SANITIZER)
  if (arg_RELEASE OR (kind STREQUAL tests AND NOT arg_SANITIZER))
    set(home RELEASE)
  endif ()
  if (arg_DISPLAY)
    target_compile_definitions(${name} PRIVATE "OVERSKETCH_SOURCE_DIR=\"${PROJECT_SOURCE_DIR}\"")
    vtk_module_autoinit(TARGETS ${name} MODULES VTK::RenderingOpenGL2 VTK::RenderingFreeType)
    # Without -noreset the server starts anew whenever the last window is gone, and the next one meets it half up.
    set(run xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" ${run})
  endif ()
  if (NOT arg_SHARDS)
    set(arg_SHARDS 1)
  endif ()
  set(tests)
  foreach (shard RANGE 1 ${arg_SHARDS})
    math(EXPR index "${shard} - 1")
    set(test ${name})
    if (arg_SHARDS GREATER 1)
      set(test ${name}_${shard})
    endif ()
    add_test(NAME ${test} COMMAND ${run})
    set_tests_properties(${test} PROPERTIES TIMEOUT 3000 COST 50 LABELS gtest
      ENVIRONMENT "${oversketch_test_caches};GTEST_TOTAL_SHARDS=${arg_SHARDS};GTEST_SHARD_INDEX=${index};GTEST_OUTPUT=json:${CMAKE_BINARY_DIR}/Testing/times/${test}.json")
    if (arg_SHARDS GREATER 1) # the longest begin first
      set_tests_properties(${test} PROPERTIES COST 200)
    endif ()
    list(APPEND tests ${test})
  endforeach ()
  oversketch_at_home(${name} ${home} ${tests})
endfunction ()

# oversketch_filter_module(<module> CLASSES <class>... [SOURCES <file>...] [NOWRAP_CLASSES <name>...] [KERNELS <target>...]): a VTK
# module whose filters are thin shells over the named kernels. SOURCES are files beside the classes that are not wrapped,
# NOWRAP_CLASSES sources with headers that other modules include.
macro (oversketch_filter_module module)
  cmake_parse_arguments(oversketch "" "" "CLASSES;KERNELS;SOURCES;NOWRAP_CLASSES" ${ARGN})
  vtk_module_add_module(${module}
    CLASSES ${oversketch_CLASSES} SOURCES ${oversketch_SOURCES} NOWRAP_CLASSES ${oversketch_NOWRAP_CLASSES})
  vtk_module_link(${module} PRIVATE ${oversketch_KERNELS})
  oversketch_module_options(${module})
endmacro ()

# oversketch_module_options(<module>): how the sources of a VTK module of ours are compiled.
function (oversketch_module_options module)
  get_property(target TARGET ${module} PROPERTY ALIASED_TARGET)
  oversketch_library_options(${target})
endfunction ()

# oversketch_library_options(<target>): the same for a library that becomes a part of one.
function (oversketch_library_options target)
  target_compile_options(${target} PRIVATE ${oversketch_filter_warnings})
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  oversketch_precompile(${target} modules
    HEADERS ${oversketch_std_headers} ${oversketch_eigen_headers} ${oversketch_vtk_headers}
    LIBRARIES Eigen3::Eigen ${oversketch_vtk_targets} POSITION_INDEPENDENT)
endfunction ()

# oversketch_application_options(<target>): the same for a library or program of the applications.
function (oversketch_application_options target)
  target_compile_options(${target} PRIVATE ${oversketch_filter_warnings})
  oversketch_precompile(${target} applications
    HEADERS ${oversketch_std_headers} ${oversketch_eigen_headers} ${oversketch_vtk_headers} LIBRARIES Eigen3::Eigen ${oversketch_vtk_targets})
endfunction ()

# oversketch_pytest(<name> <file.py> [<command>...]): one pytest file under ctest, against the package in the build tree, on
# a virtual display where it needs one (xvfb-run), run by the command. A display that resets with its last client would
# refuse the next one meanwhile. FULL: a part of the full run only.
function (oversketch_pytest name file)
  cmake_parse_arguments(PARSE_ARGV 2 arg "FULL" "" "")
  set(label home)
  if (arg_FULL)
    set(label full)
  endif ()
  if (NOT OVERSKETCH_BUILD_TESTING OR NOT OVERSKETCH_WRAP_PYTHON)
    return()
  endif ()
  add_test(NAME ${name}
    COMMAND xvfb-run -a -s "-screen 0 2560x2048x24 -noreset" ${arg_UNPARSED_ARGUMENTS} ${Python3_EXECUTABLE} -m pytest -q -s -rs -p no:cacheprovider
      ${CMAKE_CURRENT_SOURCE_DIR}/${file} --junitxml=${CMAKE_BINARY_DIR}/Testing/times/${name}.xml)
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 LABELS ${label}
    ENVIRONMENT "${oversketch_python_caches};PYTHONPATH=${oversketch_python_build};PYTHONDONTWRITEBYTECODE=1;OVERSKETCH_SOURCE=${PROJECT_SOURCE_DIR};OVERSKETCH_BUILD=${PROJECT_BINARY_DIR};OVERSKETCH_COMMAND=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/oversketch;OVERSKETCH_STUDIO=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/oversketch-studio;OVERSKETCH_TEMPORARY=${CMAKE_BINARY_DIR}/Testing/Temporary")
endfunction ()

# oversketch_link_systems(<target>): all systems that are built. Their headers are not seen by that.
function (oversketch_link_systems target)
  foreach (name IN LISTS oversketch_systems)
    target_link_libraries(${target} PUBLIC $<LINK_ONLY:Oversketch::Filters${name}>)
  endforeach ()
endfunction ()

# oversketch_see_systems(<target>): all its files see the headers of all systems that are built.
function (oversketch_see_systems target)
  foreach (name IN LISTS oversketch_systems)
    target_include_directories(${target} PRIVATE
      $<FILTER:$<TARGET_PROPERTY:Oversketch::Filters${name},INTERFACE_INCLUDE_DIRECTORIES>,EXCLUDE,^/usr/include$>)
  endforeach ()
endfunction ()

# oversketch_name_systems(<file>...): the files of this folder that name systems see the headers of all that are built, and
# OVERSKETCH_WITH_<NAME>. No other file does, or each would be compiled anew for every system that is added.
function (oversketch_name_systems)
  foreach (name IN LISTS oversketch_systems)
    string(TOUPPER "${name}" upper)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_DEFINITIONS OVERSKETCH_WITH_${upper})
    # The compiler knows /usr/include, and finds it too early where it is named.
    set_property(SOURCE ${ARGN} APPEND PROPERTY INCLUDE_DIRECTORIES
      $<FILTER:$<TARGET_PROPERTY:Oversketch::Filters${name},INTERFACE_INCLUDE_DIRECTORIES>,EXCLUDE,^/usr/include$>)
  endforeach ()
endfunction ()
