// The camera group of the proxy OversketchViewStroke: takes the camera of ParaView's active view, by itself
// for a new stroke, then whenever its button is pressed.
#ifndef oversketch_applications_para_view_plugin_pq_oversketch_camera_h
#define oversketch_applications_para_view_plugin_pq_oversketch_camera_h

#include "pqPropertyWidget.h"

#include <map>
#include <vector>

class QLabel;
class vtkSMProperty;
class vtkSMPropertyGroup;

class pqOversketchCamera : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqOversketchCamera(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqOversketchCamera() override = default;

  void apply() override;
  void reset() override;

private:
  // Remembers what the active view shows now; nothing where that has no camera.
  void takeCamera();

  vtkSMPropertyGroup* Group;
  std::map<vtkSMProperty*, std::vector<double>> Taken; // written when the user applies
  QLabel* Said;
};

#endif
