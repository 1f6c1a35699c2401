// How much of a mesh is seen from within.
#ifndef oversketch_kernels_silhouette_facing_h
#define oversketch_kernels_silhouette_facing_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/view.h"

namespace oversketch
{

// Share of what the mesh covers of the picture, 0 to 1, that shows a triangle's back in front: none of a
// closed surface that is wound outward and does not pass through itself. Looked at in at most 400 places
// along the picture's longer side, none closer than a pixel; of places at one depth a front counts. Triangles
// with a corner at or behind the eye show nothing. The same for any number of threads.
double backShare(const Mesh& mesh, const View& view, const Context& context = Context());

} // namespace oversketch
#endif
