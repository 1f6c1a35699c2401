// A mesh that is too large for steps to run on: its proxy, which they run on instead, and what they did there
// on the mesh itself.
#ifndef oversketch_applications_session_run_large_mesh_h
#define oversketch_applications_session_run_large_mesh_h

#include "session.h"

#include "vtkOversketchStepRunner.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_session
{

using Progress = oversketch::StepRunner::Listener;

constexpr vtkIdType mostTriangles = 8000000;

bool isLarge(vtkPolyData* mesh, vtkIdType most = mostTriangles);

// Whether all that the model's steps do is a motion (SystemRow::moves), which a proxy can hand on.
bool isMoved(const Model& model);

// Both throw oversketch::Error where they cannot, and are null where cancelled.

// The proxy (vtkOversketchProxy), with point array Origin, by which steps hand on where its points were. It
// has no more triangles than about `most`.
vtkSmartPointer<vtkPolyData> proxyOf(vtkPolyData* mesh,
  const Progress& progress = {},
  vtkIdType most = mostTriangles);

// The mesh, moved as its proxy was by all steps on it (vtkOversketchDetailTransfer); triangles and arrays are
// its own.
vtkSmartPointer<vtkPolyData> exactOf(vtkPolyData* mesh, vtkPolyData* proxyNow, const Progress& progress = {});

} // namespace oversketch_session
#endif
