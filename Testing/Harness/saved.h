// A mesh as a file gives it back. Header-only.
#ifndef oversketch_testing_harness_saved_h
#define oversketch_testing_harness_saved_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

namespace oversketch_test
{

// Through the bytes of a .vtp file.
inline vtkSmartPointer<vtkPolyData> saved(vtkPolyData* mesh)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  return reader->GetOutput();
}

} // namespace oversketch_test
#endif
