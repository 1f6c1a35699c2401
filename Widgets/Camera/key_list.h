// A list of keys in a corner of a renderer, over what is drawn there.
#ifndef oversketch_widgets_camera_key_list_h
#define oversketch_widgets_camera_key_list_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkRenderer;
class vtkTextActor;

namespace oversketch
{

class KeyList
{
public:
  KeyList();
  ~KeyList();
  KeyList(const KeyList&) = delete;
  KeyList& operator=(const KeyList&) = delete;

  // Null shows it nowhere.
  void show(vtkRenderer* in, const std::string& text);

private:
  vtkNew<vtkTextActor> Actor;
  vtkWeakPointer<vtkRenderer> In;
};

} // namespace oversketch
#endif
