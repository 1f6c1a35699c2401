// A window without a screen, an interactor in it, and the events of a person. Header-only.
#ifndef oversketch_testing_harness_interaction_h
#define oversketch_testing_harness_interaction_h

#include "Harness/sequences.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>

namespace oversketch_test
{

enum Modifiers
{
  NoModifier = 0,
  Shift = 1,
  Control = 2,
  Alt = 4
};

struct Window
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;

  explicit Window(int width = 400, int height = 400)
  {
    this->window->SetOffScreenRendering(1);
    this->window->SetMultiSamples(0);
    this->window->SetSize(width, height);
    this->renderer->SetBackground(1.0, 1.0, 1.0);
    this->window->AddRenderer(this->renderer);
    this->interactor->SetRenderWindow(this->window);
    this->interactor->Initialize();
  }

  vtkCamera* camera() { return this->renderer->GetActiveCamera(); }

  void event(unsigned long what, int x, int y, int modifiers = 0, const char* symbol = nullptr)
  {
    // A key's character: VTK's own bindings look at it.
    const std::string key = symbol ? symbol : "";
    this->interactor->SetEventInformation(
      x, y, modifiers & Control, modifiers & Shift, key.size() == 1 ? key[0] : '\0', 0, symbol);
    this->interactor->SetAltKey(modifiers & Alt ? 1 : 0);
    this->interactor->InvokeEvent(what);
  }
  void move(int x, int y, int modifiers = 0) { this->event(vtkCommand::MouseMoveEvent, x, y, modifiers); }
  // A key as the window systems send it: press, character, release.
  void key(const char* symbol, int modifiers = 0, int x = 200, int y = 200)
  {
    this->event(vtkCommand::KeyPressEvent, x, y, modifiers, symbol);
    this->event(vtkCommand::CharEvent, x, y, modifiers, symbol);
    this->event(vtkCommand::KeyReleaseEvent, x, y, modifiers, symbol);
  }

  // Plays a log of Testing/Recordings.
  void play(const std::string& name)
  {
    const std::string path = std::string(OVERSKETCH_SOURCE_DIR "/Testing/Recordings/") + name;
    ASSERT_TRUE(std::filesystem::exists(path)) << path;
    vtkNew<vtkInteractorEventRecorder> recorder;
    recorder->SetInteractor(this->interactor);
    recorder->KeyPressActivationOff(); // it would stop at i
    recorder->SetFileName(path.c_str());
    recorder->Play();
    recorder->Off();
  }

  // Display position of a world point [px].
  std::array<double, 2> display(const std::array<double, 3>& world)
  {
    this->renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
    this->renderer->WorldToDisplay();
    const double* at = this->renderer->GetDisplayPoint();
    return { at[0], at[1] };
  }
};

// MiB that VTK and the graphics library keep of each window that was.
inline double memoryKeptOfAWindow()
{
  const auto open = [](int windows)
  {
    for (int i = 0; i < windows; ++i)
    {
      const Window plain;
      plain.window->Render();
    }
    return memoryInUse();
  };
  constexpr int windows = 20;
  const double before = open(5);
  return (open(windows) - before) / windows;
}

// Counts how often something fires an event.
class Counter
{
public:
  Counter(vtkObject* object, unsigned long event)
    : Object(object)
  {
    this->Command->SetClientData(&this->count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* times, void*) { ++*static_cast<int*>(times); });
    object->AddObserver(event, this->Command);
  }
  ~Counter()
  {
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Command);
    }
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  int count = 0;

private:
  vtkWeakPointer<vtkObject> Object;
  vtkNew<vtkCallbackCommand> Command;
};

// While it lives, counts VTK's errors and warnings of any object instead of letting them be printed.
class Quiet
{
public:
  Quiet()
    : Before(vtkOutputWindow::GetInstance())
  {
    vtkNew<vtkOutputWindow> window;
    window->SetDisplayModeToNever();
    vtkOutputWindow::SetInstance(window);
    this->Errors = std::make_unique<Counter>(window, vtkCommand::ErrorEvent);
    this->Warnings = std::make_unique<Counter>(window, vtkCommand::WarningEvent);
  }
  ~Quiet() { vtkOutputWindow::SetInstance(this->Before); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  int errors() const { return this->Errors->count; }
  int warnings() const { return this->Warnings->count; }

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  std::unique_ptr<Counter> Errors, Warnings;
};

} // namespace oversketch_test
#endif
