// How the model is looked at: its shading and light, the ground under it and the shadow there, what it was
// over it or instead of it.
#ifndef oversketch_applications_studio_view_display_h
#define oversketch_applications_studio_view_display_h

#include "ground_shadow.h"
#include "model_view.h"
#include "resting_views.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>

class vtkActor;
class vtkLight;
class vtkLightKit;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace oversketch_studio
{

class Display
{
public:
  Display(vtkRenderer* renderer, ModelView& model);
  ~Display();

  // The camera looks at all of a box from the front, at one that lies flat where z is up from above, in a
  // view of that size [px], and the ground lies under it. `up`: 1 for y, 2 for z.
  void lookAtAll(const double box[6], const int size[2], int up);
  // From where it looks now, so that all of the models is in the picture and fills it.
  void fitAll(const int size[2]);
  // The camera steps back where not all of the models is in the picture, in a view of that size.
  void showWhole(const int size[2]);

  // Pictures and colours that models wear are seen, or not.
  void setShading(Shading shading, bool pictures)
  {
    this->setLook({ shading, this->Look.light, pictures, this->Look.plain });
  }
  void setLight(Light light);
  void setGround(bool shown);
  bool ground() const { return this->Ground; }
  void setShadow(bool shown) { this->Shadow.setShown(shown); }
  // A frame begins: the shadow is that of what is shown, or, while the hand holds something, as it was.
  void castShadow(bool isHeld);
  // Another mesh, translucent over the model; null: none.
  void showOnion(vtkPolyData* mesh);
  // Another mesh instead of the model, in its colours in any case or as models are; null: the model again.
  void showInstead(vtkPolyData* mesh, bool coloured = false);
  bool instead() const { return this->Other != nullptr; }

  // The models beside it.
  RestingViews& others() { return this->Others; }
  // Round all that is shown; not valid where nothing is.
  vtkBoundingBox box() const;

  void setDark(bool dark);
  void setPlain(const std::array<double, 3>& colour)
  {
    this->setLook({ this->Look.shading, this->Look.light, this->Look.pictures, colour });
  }
  // The ground and the onion, for a picture without them.
  void setOverlays(bool shown);

private:
  void stepBack(const double box[6], const int size[2]);
  void placeGround(const double box[6], int up); // under the box, and wider than it
  void showGround(bool shown);
  void setLook(const ModelLook& look);

  vtkRenderer* Renderer; // outlives it
  ModelView& Model;
  RestingViews Others{ this->Renderer };
  vtkNew<vtkLightKit> Kit;
  vtkNew<vtkLight> Head; // instead of those
  GroundShadow Shadow{ this->Renderer };
  vtkNew<vtkPolyData> Lines, Middle; // on the ground, a round number apart; the middle ones: along x and z
  vtkNew<vtkActor> LineActor, MiddleActor;
  vtkNew<vtkPolyDataMapper> OnionMappers[2];
  vtkNew<vtkActor> Onions[2];       // what sticks out of the model; faintly, all of it
  std::unique_ptr<ModelView> Other; // while it is shown
  ModelLook Look;
  bool Ground = false;
};

} // namespace oversketch_studio
#endif
