// OpenCL's C++ binding as all kernels use it: version 1.2, with exceptions.
#ifndef oversketch_kernels_open_cl_opencl_h
#define oversketch_kernels_open_cl_opencl_h

#define CL_TARGET_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>

#endif
