// a * x + y, and the size of the group that ran it.
kernel void saxpy(const float a, global const float* x, global float* y, global int* groupSize)
{
  const size_t i = get_global_id(0);
  y[i] = a * x[i] + y[i];
  groupSize[i] = (int)get_local_size(0);
}
