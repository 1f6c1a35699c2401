#include "vtkOversketchStellarRaised.h"

#include "vtkOversketchStellarRegister.h"
#include "vtkOversketchStellarTools.h"

namespace oversketch
{

namespace
{

Register<Raised>& TheRaised()
{
  static Register<Raised> instance;
  return instance;
}

} // namespace

void AddRaised(vtkPolyData* mesh, const std::shared_ptr<const Raised>& raised)
{
  TheRaised().Add(StellarKey(mesh), raised);
}

std::shared_ptr<const Raised> RaisedOf(vtkPolyData* mesh)
{
  return TheRaised().Find(StellarKey(mesh));
}

} // namespace oversketch
