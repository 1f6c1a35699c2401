// Tells whether a window's pictures are drawn by the processor (Mesa's llvmpipe or softpipe): ambient
// occlusion and several samples a pixel would make each frame wait. Edges are then smoothed when nothing
// moves.
#ifndef oversketch_applications_studio_view_draws_on_processor_h
#define oversketch_applications_studio_view_draws_on_processor_h

class vtkRenderWindow;

namespace oversketch_studio
{

constexpr int edgeSamples = 4; // a pixel, where edges are smoothed
constexpr int restTime = 200;  // ms without a frame, after which nothing moves any more

// Asks the context, which must be there.
bool drawsOnProcessor(vtkRenderWindow* window);

} // namespace oversketch_studio
#endif
