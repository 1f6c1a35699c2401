// A point as a weighted mean of others.
#ifndef oversketch_kernels_mesh_mix_h
#define oversketch_kernels_mesh_mix_h

#include <utility>
#include <vector>

namespace oversketch
{

// Points and their weights, which add up to 1.
using Mix = std::vector<std::pair<int, double>>;

// The same mix with its points ascending and each of them once; none whose weight is rounding (below 1e-12).
Mix normalisedMix(Mix mix);

// Whether two normalised mixes are the same place: weights to within 1e-9.
bool sameMix(const Mix& a, const Mix& b);

} // namespace oversketch
#endif
