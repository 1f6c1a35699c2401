#include "Sparse/drag.h"

namespace oversketch
{

template <class Real>
void Drag::place(const Vector3& d, Real* points, const Context& context) const
{
  const int count = static_cast<int>(this->vertices.size());
  const bool turns = this->response.size() != this->vertices.size();
  const auto body = [&](int begin, int end)
  {
    const double x = d[0], y = d[1], z = d[2];
    for (int i = begin; i < end; ++i)
    {
      const double* from = this->rest[i].data();
      Real* point = points + static_cast<std::ptrdiff_t>(3) * this->vertices[i];
      if (turns)
      {
        const double* r = this->response.data() + static_cast<std::ptrdiff_t>(9) * i;
        point[0] = static_cast<Real>(from[0] + (r[0] * x + r[3] * y + r[6] * z));
        point[1] = static_cast<Real>(from[1] + (r[1] * x + r[4] * y + r[7] * z));
        point[2] = static_cast<Real>(from[2] + (r[2] * x + r[5] * y + r[8] * z));
      }
      else
      {
        const double r = this->response[i];
        point[0] = static_cast<Real>(from[0] + r * x);
        point[1] = static_cast<Real>(from[1] + r * y);
        point[2] = static_cast<Real>(from[2] + r * z);
      }
    }
  };
  // Below this, waking another thread takes longer than the work.
  constexpr int worthThreads = 65536;
  count < worthThreads ? body(0, count) : context.parallelFor(count, body);
}

template void Drag::place(const Vector3& d, float* points, const Context& context) const;
template void Drag::place(const Vector3& d, double* points, const Context& context) const;

} // namespace oversketch
