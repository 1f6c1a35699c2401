#include "pqOversketchCamera.h"

#include "pqActiveObjects.h"
#include "pqView.h"
#include "vtkCamera.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMViewProxy.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

pqOversketchCamera::pqOversketchCamera(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, parent)
  , Group(group)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* button = new QPushButton(tr("Take the camera of the view"), this);
  button->setObjectName("TakeCamera");
  button->setToolTip(tr("The line is read as drawn over what the active view shows now."));
  this->Said = new QLabel(this);
  this->Said->setWordWrap(true);
  layout->addWidget(button);
  layout->addWidget(this->Said);
  this->setShowLabel(false);
  this->connect(button, &QPushButton::clicked, this, &pqOversketchCamera::takeCamera);

  bool fresh = true;
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    fresh = fresh && group->GetProperty(i)->IsValueDefault();
  }
  if (fresh)
  {
    this->takeCamera();
  }
}

void pqOversketchCamera::takeCamera()
{
  pqView* view = pqActiveObjects::instance().activeView();
  auto* camera = vtkSMRenderViewProxy::SafeDownCast(view ? view->getViewProxy() : nullptr);
  if (!camera)
  {
    this->Said->setText(tr("The active view has no camera; choose a render view."));
    return;
  }
  camera->SynchronizeCameraProperties();
  for (unsigned int i = 0; i < this->Group->GetNumberOfProperties(); ++i)
  {
    // The proxy names its properties as the view does.
    vtkSMProperty* property = this->Group->GetProperty(i);
    const char* name = this->Group->GetFunction(property);
    this->Taken[property] = vtkSMPropertyHelper(camera, name).GetDoubleArray();
    if (QString(name) == "CameraParallelProjection")
    {
      // A view in 2D is parallel whatever this property of it says.
      this->Taken[property] = { static_cast<double>(camera->GetActiveCamera()->GetParallelProjection()) };
    }
  }
  this->Said->setText(tr("Drawn over %1.").arg(view->getSMName()));
  Q_EMIT this->changeAvailable();
  Q_EMIT this->changeFinished();
}

void pqOversketchCamera::apply()
{
  this->Superclass::apply();
  for (const auto& [property, values] : this->Taken)
  {
    const auto count = static_cast<unsigned int>(values.size());
    if (vtkSMIntVectorProperty::SafeDownCast(property))
    {
      vtkSMPropertyHelper(property).Set(std::vector<int>(values.begin(), values.end()).data(), count);
    }
    else
    {
      vtkSMPropertyHelper(property).Set(values.data(), count);
    }
  }
  if (!this->Taken.empty())
  {
    this->proxy()->UpdateVTKObjects(); // the panel does it for properties with widgets of its own only
    this->Taken.clear();
  }
}

void pqOversketchCamera::reset()
{
  this->Taken.clear();
  this->Said->clear();
  this->Superclass::reset();
}
