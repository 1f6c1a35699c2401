// System B: all that its speed is judged by, in one process, each beside its limit or peers; where there are
// peers, the figures beside the times compare the results.
#include "edit_jobs.h"

namespace oversketch_bench
{

void jobs()
{
  addMoves();
  addExponentials();
  addShading();
  addDistances();
  addTriangles();
}

} // namespace oversketch_bench
