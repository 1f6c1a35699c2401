// Calls of OpenCV: its failures become the house's, and write nothing to the standard error stream.
#ifndef oversketch_kernels_stroke_with_opencv_h
#define oversketch_kernels_stroke_with_opencv_h

#include "Mesh/context.h"

#include <opencv2/core.hpp>

#include <mutex>
#include <string>

namespace oversketch
{

// Runs body, which calls OpenCV; its exceptions come out as Error(Failure::Unexpected) that names `what`
// could not be done. OpenCV's handler of errors is one for the process: it is lent for the call, one call at
// a time, and given back.
template <typename Body>
void withOpenCV(const std::string& what, const Body& body)
{
  static std::mutex one;
  const std::lock_guard<std::mutex> lock(one);
  struct Lent
  {
    void* data = nullptr;
    cv::ErrorCallback before;
    Lent()
      : before(cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; },
          nullptr,
          &this->data))
    {
    }
    Lent(const Lent&) = delete;
    Lent& operator=(const Lent&) = delete;
    ~Lent() { cv::redirectError(this->before, this->data); }
  };
  const Lent quiet;
  try
  {
    body();
  }
  catch (const cv::Exception& failure)
  {
    throw Error(Failure::Unexpected, "OpenCV could not %1: %2", what, failure.err);
  }
}

} // namespace oversketch
#endif
