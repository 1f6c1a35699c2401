// A stroke that draws the bunny's ear longer: the same picture for every size of the model.
#ifndef oversketch_testing_benchmarks_bunny_stroke_h
#define oversketch_testing_benchmarks_bunny_stroke_h

#include "benchmark_frame.h"

#include "Mesh/view.h"

namespace oversketch_bench
{

// The bunny from the front, 800 x 600 pixels, turned by so many degrees round the vertical.
View bunnyView(double degrees = 0.0);

// The highest stretch of the outline in bunnyView(), 160 px long, its middle drawn `pixels` higher.
vtkSmartPointer<vtkPolyData> earStroke(vtkPolyData* bunny, double pixels = 25.0);

} // namespace oversketch_bench
#endif
