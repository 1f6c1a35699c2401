// Shares and sums of transformations: the logarithm of a 4x4 matrix, and what is made of it.
#ifndef oversketch_kernels_matrix_logarithm_h
#define oversketch_kernels_matrix_logarithm_h

#include <Eigen/Core>

namespace oversketch
{

using Matrix4 = Eigen::Matrix4d;

// The principal logarithm, the X whose eigenvalues' imaginary parts are within (-pi, pi) and whose
// exponential is the matrix. That of an affine matrix has a last row of zeros. Throws
// Error(Failure::SolveFailed) where none is real: for a reflection, half a turn and what else has an
// eigenvalue on the negative real axis (or within a millionth of its direction), for a singular matrix and
// one that is not finite; and where exp(X) is not the matrix to 1e-9 of its norm.
//
// Why not Eigen's log() alone: it returns zero for reflections and half turns without a word.
Matrix4 logarithm(const Matrix4& matrix);

Matrix4 exponential(const Matrix4& matrix);

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", equations 8.1 to 8.3, after
// M. Alexa, "Linear Combination of Transformations". All throw what logarithm() throws.
//
// s A = exp(s log A): twice the half of A is A.
Matrix4 shareOf(const Matrix4& a, double share);
// A + B = exp(log A + log B): both at once, in no order; A B where A B = B A.
Matrix4 together(const Matrix4& a, const Matrix4& b);
// (1 - t) A + t B.
Matrix4 between(const Matrix4& a, const Matrix4& b, double t);

} // namespace oversketch
#endif
