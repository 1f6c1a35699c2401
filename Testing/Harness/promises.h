// What every filter promises of bad input and of cancelling, asked in one way. Header-only.
#ifndef oversketch_testing_harness_promises_h
#define oversketch_testing_harness_promises_h

#include "Harness/polydata.h"
#include "Mesh/context.h"

#include "vtkErrorCode.h"
#include "vtkPolyDataAlgorithm.h"

#include <gtest/gtest.h>

namespace oversketch_test
{

// The error code of a filter that failed.
inline unsigned long codeOf(oversketch::Failure failure)
{
  return vtkErrorCode::UserError + static_cast<unsigned long>(failure);
}

// The filter refuses its input: one error of the given kind with the words in it, an empty output, and no
// stale data in the next run either.
inline void expectRefusal(vtkPolyDataAlgorithm* filter, oversketch::Failure failure, const std::string& words)
{
  Ear ear(filter);
  filter->Update();
  ASSERT_EQ(ear.errors.size(), 1u) << words;
  EXPECT_NE(ear.errors[0].find(words), std::string::npos) << ear.errors[0];
  EXPECT_EQ(filter->GetErrorCode(), codeOf(failure)) << words;
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << words;
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << "stale data after: " << words;
}

// Cancels a run at its first progress beyond the given share: it ends silently, with an empty output. The
// filter is left ready to run again.
inline void expectCancel(vtkPolyDataAlgorithm* filter, double beyond = -1.0)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&beyond);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* share, void* progress)
    {
      if (*static_cast<double*>(progress) > *static_cast<double*>(share))
      {
        static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
  Ear ear(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), codeOf(oversketch::Failure::Cancelled));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(ear.errors.empty());
  filter->RemoveObserver(tag);
  filter->AbortExecuteOff();
  filter->Modified();
}

} // namespace oversketch_test
#endif
