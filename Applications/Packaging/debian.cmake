# Four Debian packages: liboversketch, liboversketch-dev, python3-oversketch, and oversketch with the command and the Studio.
set(names runtime liboversketch development liboversketch-dev python python3-oversketch application oversketch)
set(python_minor "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
math(EXPR python_next "${Python3_VERSION_MINOR} + 1")
string(CONCAT about "Draw a line beside a model's outline, and the limb that is meant\n"
  "follows it: a toolkit of VTK filters, from silhouette curves to\nLaplacian deformation.")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME oversketch)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "The Oversketch developers")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime development python application)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Oversketch developers <oversketch@example.org>")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(own "liboversketch (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "pocl-opencl-icd | opencl-icd")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/triggers")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "sketch-based mesh modelling, libraries\n${about}\n\nThe shared libraries.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${own}, libvtk9-dev, libeigen3-dev, ocl-icd-opencl-dev, opencl-clhpp-headers")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "sketch-based mesh modelling, headers\n${about}\n\nHeaders, and files for CMake's find_package.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "${own}, python3-vtk9, python3-numpy, python3 (>= ${python_minor}), python3 (<< ${Python3_VERSION_MAJOR}.${python_next})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "xvfb, python3-aiohttp | python3-venv") # of oversketch-web
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/python/postinst;${CMAKE_CURRENT_LIST_DIR}/python/prerm")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "sketch-based mesh modelling, Python package\n${about}\n\nThe Python package.")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_DEPENDS "${own}")
set(CPACK_COMPONENT_APPLICATION_DESCRIPTION
  "sketch-based mesh modelling, command and window\n${about}\n\nThe command oversketch, the window oversketch-studio, and models and\nstrokes to begin with.")

while (names)
  list(POP_FRONT names component package)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  install(FILES copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component})
  oversketch_compressed("${PROJECT_SOURCE_DIR}/CHANGELOG.md" changelog-${package}
    "${CMAKE_INSTALL_DATADIR}/doc/${package}" ${component})
endwhile ()
include(CPack)
