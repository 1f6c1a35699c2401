#include "view_menu.h"

#include "axis_gizmo.h"
#include "document.h"
#include "point_normals.h"
#include "view_bar.h"
#include "viewport.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <QAction>
#include <QActionGroup>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QSettings>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr int barMargin = 6;            // px as Qt counts them, about what lies over the view
constexpr vtkIdType fineMesh = 200'000; // whose faces are too small to be seen by themselves

// As 12,345 is written short.
QString shortNumber(vtkIdType count)
{
  const QLocale here;
  if (count < 10'000)
  {
    return here.toString(static_cast<qlonglong>(count));
  }
  return count < 1'000'000 ? ViewMenu::tr("%1k").arg(count / 1000)
                           : ViewMenu::tr("%1M").arg(here.toString(static_cast<double>(count) / 1e6, 'f', 1));
}

// Quads count as two each.
vtkIdType trianglesIn(vtkPolyData* mesh)
{
  return mesh->GetPolys()->GetNumberOfConnectivityIds() - 2 * mesh->GetNumberOfPolys();
}

} // namespace

ViewSettings ViewSettings::read()
{
  const QSettings settings;
  ViewSettings kept;
  const int shading = settings.value("view/shading", 0).toInt();
  kept.shading = shading > 0 && shading < shadings ? static_cast<Shading>(shading) : Shading::Smooth;
  const int light = settings.value("view/light", 0).toInt();
  kept.light = light > 0 && light < lights ? static_cast<Light>(light) : Light::Three;
  kept.parallel = settings.value("view/parallel", kept.parallel).toBool();
  kept.free = settings.value("view/free", kept.free).toBool();
  kept.ground = settings.value("view/ground", kept.ground).toBool();
  kept.shadow = settings.value("view/shadow", kept.shadow).toBool();
  return kept;
}

void ViewSettings::write() const
{
  QSettings settings;
  settings.setValue("view/shading", static_cast<int>(this->shading));
  settings.setValue("view/light", static_cast<int>(this->light));
  settings.setValue("view/parallel", this->parallel);
  settings.setValue("view/free", this->free);
  settings.setValue("view/ground", this->ground);
  settings.setValue("view/shadow", this->shadow);
}

ViewMenu::ViewMenu(Viewport* view, Document* document, std::function<int()> node, QWidget* parent)
  : QObject(parent)
  , View(view)
  , Shown(document)
  , Node(std::move(node))
  , Settings(ViewSettings::read())
  , Camera(std::make_unique<QMenu>(tr("&Camera")))
  , Model(std::make_unique<QMenu>(tr("&Model as")))
  , Gizmo(new AxisGizmo(view))
  , Triangles(new QLabel(parent))
{
  this->makeCamera();
  this->makeShadings();
  this->makeLights();
  this->Ground = this->addToggle(tr("&Ground grid"), {}, [this](bool on) { this->Settings.ground = on; });
  this->Shadow = this->addToggle(tr("Shado&w"), {}, [this](bool on) { this->Settings.shadow = on; });
  this->Shadow->setToolTip(tr("What the model throws on the ground, soft as under a wide light above it"));
  this->Onion = this->addToggle(tr("&Onion of the original"), {}, [](bool) {});
  this->Onion->setIconText(tr("Onion"));
  this->Onion->setToolTip(tr("The model as it was opened, through the present one"));
  this->Before = new QAction(tr("&Before the selected step (hold U)"), this);
  this->Before->setCheckable(true);
  connect(this->Before, &QAction::toggled, this, &ViewMenu::showBefore);
  this->Picture = this->addToggle(tr("Pictures o&f models"), tr("F"), [](bool) {});
  this->Picture->setIconText(tr("Picture"));
  this->Picture->setToolTip(tr("What the model wears, or its form alone (F)"));
  this->Picture->setChecked(true);
  this->Bar = new ViewBar(this->Camera.get(), this->Model.get(), { this->Picture, this->Onion }, view);
  this->Triangles->setObjectName("triangles");
  view->installEventFilter(this);
  // A stroke's view and a session's have projections of their own.
  connect(this->Gizmo,
    &AxisGizmo::projected,
    this,
    [this](bool parallel)
    {
      this->Parallel->setChecked(parallel);
      this->setTexts();
    });
  connect(view, &Viewport::meshShown, this, &ViewMenu::refresh);
  connect(view, &Viewport::keysShown, this, &ViewMenu::placeOverlays);
  connect(document, &Document::opened, this, &ViewMenu::showOnion);
  connect(document, &Document::changed, this, [this] { this->Before->setChecked(false); });
  connect(document,
    &Document::beforeCame,
    this,
    [this](const oversketch_session::SharedData& mesh)
    {
      if (this->Before->isChecked())
      {
        this->View->showInstead(mesh);
      }
    });
  view->renderer()->GetActiveCamera()->SetParallelProjection(this->Settings.parallel);
  this->Parallel->setChecked(this->Settings.parallel);
  this->Free->setChecked(this->Settings.free);
  this->Ground->setChecked(this->Settings.ground);
  this->Shadow->setChecked(this->Settings.shadow);
  this->Lights[static_cast<int>(this->Settings.light)]->setChecked(true);
  this->Shadings[static_cast<int>(this->Settings.shading)]->setChecked(true);
  this->apply();
  this->refresh();
}

ViewMenu::~ViewMenu() = default;

QAction* ViewMenu::addToggle(const QString& text, const QString& key, const std::function<void(bool)>& run)
{
  auto* action = new QAction(text, this);
  action->setCheckable(true);
  action->setShortcut(QKeySequence(key));
  connect(action,
    &QAction::triggered,
    this,
    [this, run](bool on)
    {
      run(on);
      this->Settings.write();
      this->apply();
    });
  return action;
}

void ViewMenu::makeCamera()
{
  QMenu* menu = this->Camera.get();
  this->Parallel = this->addToggle(tr("Ort&hographic"),
    tr("5"),
    [this](bool on)
    {
      this->Settings.parallel = on;
      this->View->camera()->SetParallelProjection(on);
    });
  this->Free =
    this->addToggle(tr("Turn fr&eely, as a ball"), {}, [this](bool on) { this->Settings.free = on; });
  this->UpZ =
    this->addToggle(tr("&Z is up"), {}, [this](bool on) { this->View->setUpAxis(on ? 2 : 1, true); });
  this->UpZ->setToolTip(
    tr("The model stands on the plane of x and y, as many scans and CAD models do; else y is up"));
  menu->addActions({ this->Parallel, this->Free, this->UpZ });
  menu->addSeparator();
  QAction* fit = menu->addAction(tr("F&it"));
  fit->setShortcut(QKeySequence(tr("Home")));
  fit->setShortcutContext(Qt::WidgetShortcut); // in sliders, lists and texts the key has a use of its own
  this->View->addAction(fit);
  fit->setToolTip(tr("All of the model in the view"));
  connect(fit, &QAction::triggered, this->View, &Viewport::fitAll);
  const struct
  {
    QString text, key;
    int axis;
    bool negative;
  } sides[] = { { tr("&Front"), tr("Ctrl+1"), 2, false },
    { tr("&Right"), tr("Ctrl+2"), 0, false },
    { tr("&Top"), tr("Ctrl+3"), 1, false },
    { tr("&Back"), tr("Ctrl+4"), 2, true },
    { tr("&Left"), tr("Ctrl+5"), 0, true },
    { tr("B&ottom"), tr("Ctrl+6"), 1, true } };
  for (const auto& side : sides)
  {
    QAction* action = menu->addAction(side.text);
    action->setShortcut(QKeySequence(side.key));
    connect(action,
      &QAction::triggered,
      this,
      [this, axis = side.axis, negative = side.negative]
      {
        // Where z is up the front is that of -y.
        const bool isZ = this->UpZ->isChecked() && axis != 0;
        this->View->camera()->LookFromSide(isZ ? 3 - axis : axis, isZ && axis == 2 ? !negative : negative);
      });
  }
}

void ViewMenu::makeShadings()
{
  const struct
  {
    QString text, inBar, help;
  } all[shadings] = {
    { tr("&Smooth"), tr("Smooth"), tr("Edges of 60 degrees and more of a model that has many stay sharp") },
    { tr("&Flat"), tr("Flat"), tr("Each face by itself") },
    { tr("&Wireframe over shade"), tr("Wire"), tr("The edges of the triangles as well") },
    { tr("&Clay (matcap)"), tr("Clay"), tr("As a ball of clay is lit: shows dents and creases") }
  };
  auto* group = new QActionGroup(this);
  for (int i = 0; i < shadings; ++i)
  {
    QAction* action =
      this->addToggle(all[i].text, {}, [this, i](bool) { this->Settings.shading = static_cast<Shading>(i); });
    action->setIconText(all[i].inBar);
    action->setToolTip(all[i].help);
    group->addAction(action);
    this->Model->addAction(action);
    this->Shadings << action;
  }
}

void ViewMenu::makeLights()
{
  const struct
  {
    QString text, help;
  } all[lights] = { { tr("Lit by &three lights"), tr("From above, from below and from behind") },
    { tr("Lit by a &headlight"), tr("From where you look") },
    { tr("Lit as a &ball of plaster (matcap)"),
      tr("By the way the surface faces alone, in the colours and pictures that it wears") } };
  auto* group = new QActionGroup(this);
  this->Model->addSeparator();
  for (int i = 0; i < lights; ++i)
  {
    QAction* action =
      this->addToggle(all[i].text, {}, [this, i](bool) { this->Settings.light = static_cast<Light>(i); });
    action->setToolTip(all[i].help);
    group->addAction(action);
    this->Model->addAction(action);
    this->Lights << action;
  }
}

void ViewMenu::setUpAxis(int axis)
{
  this->UpZ->setChecked(axis == 2);
  this->View->setUpAxis(axis, false);
}

void ViewMenu::addTo(QMenu* menu)
{
  menu->addMenu(this->Camera.get());
  menu->addMenu(this->Model.get());
  menu->addActions({ this->Picture, this->Ground, this->Shadow, this->Onion, this->Before });
}

void ViewMenu::setDark(bool dark)
{
  this->Gizmo->setDark(dark);
}

void ViewMenu::apply()
{
  Display& display = this->View->display();
  display.setShading(this->Settings.shading, this->Picture->isChecked());
  display.setLight(this->Settings.light);
  display.setGround(this->Settings.ground);
  display.setShadow(this->Settings.shadow);
  this->View->camera()->SetOrbit(
    this->Settings.free ? vtkOversketchInteractorStyle::Trackball : vtkOversketchInteractorStyle::Turntable);
  this->setTexts();
  this->showOnion();
}

void ViewMenu::setTexts()
{
  this->Bar->setTexts(this->Parallel->isChecked() ? tr("Ortho") : tr("Persp"),
    this->Shadings[static_cast<int>(this->Settings.shading)]->iconText());
  this->placeOverlays();
}

void ViewMenu::showOnion()
{
  const vtkSmartPointer<vtkPolyData> original =
    this->Shown->isOpen() ? this->Shown->session().mesh.own() : nullptr;
  this->Onion->setEnabled(original != nullptr);
  const bool isShown = original && this->Onion->isChecked(),
             isFine = isShown && original->GetNumberOfPolys() > fineMesh;
  this->View->display().showOnion(!isShown ? nullptr
                                  : isFine ? original.Get()
                                           : oversketch_files::withPointNormals(original).Get());
  this->View->renderSoon();
}

void ViewMenu::refresh()
{
  vtkPolyData* mesh = this->View->mesh();
  vtkPolyData* whole = mesh && this->Shown->isOpen() ? this->Shown->session().whole.Get() : nullptr;
  const auto inFull = [](vtkPolyData* of)
  { return QLocale().toString(static_cast<qlonglong>(trianglesIn(of))); };
  const QString count = mesh ? shortNumber(trianglesIn(mesh)) : QString();
  this->Triangles->setText(!mesh   ? QString()
                           : whole ? tr("%1 of %2 tri").arg(count, shortNumber(trianglesIn(whole)))
                                   : tr("%1 tri").arg(count));
  this->Triangles->setToolTip(!mesh   ? QString()
                              : whole ? tr("shown by %1 of %2 triangles").arg(inFull(mesh), inFull(whole))
                                      : tr("%1 triangles").arg(inFull(mesh)));
}

void ViewMenu::showBefore(bool shown)
{
  const int node = shown ? this->Node() : -1;
  if (node >= 0)
  {
    this->Shown->requestBefore(node);
    emit this->told(tr("Before: %1").arg(QString::fromStdString(this->Shown->nodeAt(node)->name)));
    return;
  }
  this->View->showInstead(nullptr);
  emit this->told({});
}

// The strip at the left, the axes at the right, below the strip where there is no room beside it.
void ViewMenu::placeOverlays()
{
  this->Bar->setVisible(!this->View->showsKeys()); // the list is there
  this->Gizmo->setVisible(!this->View->showsKeys());
  this->Bar->fit(this->View->width() - 2 * barMargin);
  this->Bar->move(barMargin, barMargin);
  const int right = this->View->width() - this->Gizmo->width() - barMargin;
  const bool beside = right > this->Bar->geometry().right() + barMargin;
  this->Gizmo->move(
    std::max(barMargin, right), beside ? barMargin : this->Bar->geometry().bottom() + barMargin);
}

bool ViewMenu::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Resize:
      this->placeOverlays();
      break;
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->key() == Qt::Key_U && key->modifiers() == Qt::NoModifier)
      {
        if (!key->isAutoRepeat())
        {
          this->Before->setChecked(event->type() == QEvent::KeyPress);
        }
        return true;
      }
      break;
    }
    case QEvent::FocusOut:
      this->Before->setChecked(false);
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

} // namespace oversketch_studio
