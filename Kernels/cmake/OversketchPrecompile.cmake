# Headers that most files of a kind include, compiled once for all targets of it. A build without them is made by
# CMAKE_DISABLE_PRECOMPILE_HEADERS, the preset `plain`: each file must include what it needs itself.
set(oversketch_std_headers <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numeric> <optional> <set>
  <sstream> <string> <utility> <vector>)
set(oversketch_eigen_headers <Eigen/Core> <Eigen/Geometry>)
set(oversketch_vtk_headers <vtkCellArray.h> <vtkCellData.h> <vtkDoubleArray.h> <vtkFieldData.h> <vtkImageData.h> <vtkInformation.h>
  <vtkInformationVector.h> <vtkIntArray.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkPolyData.h>
  <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h> <vtkSMPTools.h> <vtkUnsignedCharArray.h>)
set(oversketch_vtk_targets VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel)
set(oversketch_qt_headers <QtWidgets>)

# oversketch_precompile(<target> <name> [HEADERS <header>...] [LIBRARIES <target>...] [OPTIONS <option>...] [POSITION_INDEPENDENT]):
# the target takes the headers compiled under that name, which the first call makes. Targets of one name must agree in the
# options that a precompiled header depends on: optimization and position-independent code.
function (oversketch_precompile target name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "POSITION_INDEPENDENT" "" "HEADERS;LIBRARIES;OPTIONS")
  if (CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif ()
  set(donor oversketch_headers_${name})
  if (NOT TARGET ${donor})
    file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/headers/${name}.cxx" CONTENT "")
    set_source_files_properties("${CMAKE_BINARY_DIR}/headers/${name}.cxx" PROPERTIES GENERATED ON)
    add_library(${donor} OBJECT "${CMAKE_BINARY_DIR}/headers/${name}.cxx")
    set_target_properties(${donor} PROPERTIES EXCLUDE_FROM_ALL ON AUTOMOC OFF UNITY_BUILD OFF)
    if (arg_POSITION_INDEPENDENT)
      set_target_properties(${donor} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif ()
    get_target_property(visibility ${target} CXX_VISIBILITY_PRESET)
    set_target_properties(${donor} PROPERTIES CXX_VISIBILITY_PRESET ${visibility})
    target_link_libraries(${donor} PRIVATE ${arg_LIBRARIES})
    target_compile_options(${donor} PRIVATE ${arg_OPTIONS})
    target_precompile_headers(${donor} PRIVATE ${arg_HEADERS})
  endif ()
  target_precompile_headers(${target} REUSE_FROM ${donor})
endfunction ()
