// The filters from a mesh and its handles to a region with a smooth border.
#ifndef oversketch_filters_region_testing_region_pipeline_h
#define oversketch_filters_region_testing_region_pipeline_h

#include "Harness/polydata.h"
#include "vtkOversketchMixtureRegion.h"
#include "vtkOversketchRegionBorder.h"
#include "vtkOversketchShapeDiameter.h"

#include <vector>

namespace oversketch_test
{

// Mesh to border-smoothed region; handles from the tip of limb 1 where none are given.
struct Pipeline
{
  Mesh mesh;
  vtkNew<vtkOversketchShapeDiameter> diameter;
  vtkNew<vtkOversketchMixtureRegion> region;
  vtkNew<vtkOversketchRegionBorder> border;

  explicit Pipeline(const Mesh& surface)
    : mesh(surface)
  {
    this->diameter->SetInputData(toPolyData(surface));
    this->region->SetInputConnection(this->diameter->GetOutputPort());
    this->border->SetInputConnection(this->region->GetOutputPort());
  }
  void asPublished()
  {
    this->region->SetSeedMargin(0.0);
    this->region->FillIslandsOff();
    this->region->LimitRunawayOff();
    this->region->CutAtJunctionOff();
    this->region->ReachEndsOff();
    this->region->ConfineToSectionOff();
    this->region->EvenSamplesOff();
    this->region->IgnoreNoiseOff();
    this->diameter->TurnConesOff();
    this->border->ConfineOff();
  }
  std::vector<char> grown()
  {
    this->region->Update();
    return flagsOf(this->region->GetOutput(), "Region");
  }
  std::vector<char> smoothed()
  {
    this->border->Update();
    return flagsOf(this->border->GetOutput(), "Region");
  }
};

} // namespace oversketch_test
#endif
