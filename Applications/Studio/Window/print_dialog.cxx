#include "print_dialog.h"

#include "message_text.h"
#include "print_colours.h"

#include "Print/print_facts.h"
#include "vtkOversketchPrintCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStringList>

namespace oversketch_studio
{

namespace
{

constexpr double usualHeight = 100.0, usualWall = 0.8; // mm; two lines of a usual nozzle

QDoubleSpinBox* lengthField(const char* setting,
  double usual,
  double least,
  const QString& tip,
  QWidget* parent)
{
  auto* field = new QDoubleSpinBox(parent);
  field->setObjectName(setting);
  field->setRange(least, 10000.0);
  field->setDecimals(2);
  field->setSuffix(PrintDialog::tr(" mm"));
  field->setKeyboardTracking(false);
  field->setToolTip(tip);
  field->setValue(QSettings().value(setting, usual).toDouble());
  return field;
}

} // namespace

PrintDialog::PrintDialog(vtkOversketchPrintCheck* check,
  int up,
  const std::function<void(vtkPolyData*)>& show,
  QWidget* parent)
  : QDialog(parent)
  , Check(check)
  , Up(up)
  , Show(show)
  , Height(lengthField("printHeight", usualHeight, 0.1, tr("All of the model is scaled by it, evenly"), this))
  , Wall(lengthField("printWall", usualWall, 0.0, tr("Thinner walls are red, and not ready to print"), this))
  , Words(new QLabel(this))
  , Verdict(new QLabel(this))
{
  this->setObjectName("print");
  this->setWindowTitle(tr("Export for print"));
  this->setAttribute(Qt::WA_DeleteOnClose);
  this->Words->setObjectName("words");
  this->Verdict->setObjectName("verdict");
  auto* colours =
    new QLabel(tr("<font color='#d73027'>■</font> too thin <font color='#e0a030'>■</font> nearly <font "
                  "color='#4575b4'>■</font> thick <font color='#969696'>■</font> no wall <font "
                  "color='#191919'>■</font> faulty"),
      this);
  for (QLabel* label : { this->Words, this->Verdict, colours })
  {
    label->setWordWrap(true);
    label->setMinimumWidth(340);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Cancel)->setText(tr("&Cancel"));
  this->Write = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
  for (QAbstractButton* button : buttons->buttons()) // Return in a field confirms that alone
  {
    qobject_cast<QPushButton*>(button)->setAutoDefault(false);
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Height"), this->Height);
  form->addRow(tr("Thinnest &wall"), this->Wall);
  form->addRow(this->Words);
  form->addRow(colours);
  form->addRow(this->Verdict);
  form->addRow(buttons);
  for (QDoubleSpinBox* field : { this->Height, this->Wall })
  {
    connect(field,
      QOverload<double>::of(&QDoubleSpinBox::valueChanged),
      this,
      [this, field](double value)
      {
        QSettings().setValue(field->objectName(), value);
        this->tell();
      });
  }
  this->tell();
}

PrintDialog::~PrintDialog() = default;

double PrintDialog::extent() const
{
  const oversketch::Vector3& size = this->Check->Found().size;
  return size[this->Up] > 0.0 ? size[this->Up] : size.maxCoeff() > 0.0 ? size.maxCoeff() : 1.0;
}

double PrintDialog::millimetres() const
{
  return this->Height->value() / this->extent();
}

void PrintDialog::tell()
{
  const double wall = this->Wall->value() / this->millimetres();
  this->Check->SetWall(wall);
  QStringList words;
  QString verdict;
  for (const oversketch::PrintFact& fact :
    oversketch::printFacts(this->Check->Found(), wall, this->millimetres()))
  {
    verdict = plainWords(fact.words);
    words << (fact.isFault ? QStringLiteral("✗ ") : QStringLiteral("✓ ")) + verdict;
  }
  const bool isReady = this->Check->IsReady();
  if (words.size() > 1)
  {
    words.removeLast();
  }
  this->Words->setText(words.join('\n'));
  this->Verdict->setText(isReady ? verdict : tr("%1 It can be written all the same.").arg(verdict));
  this->Write->setText(isReady ? tr("&Write…") : tr("&Write all the same…"));
  this->Show(oversketch_files::colouredByWall(this->Check->GetOutput(), wall));
  this->adjustSize();
}

vtkSmartPointer<vtkPolyData> PrintDialog::printed() const
{
  vtkPolyData* checked = this->Check->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataType(checked->GetPoints()->GetDataType());
  points->SetNumberOfPoints(checked->GetNumberOfPoints());
  double box[6];
  checked->GetBounds(box);
  const double unit = this->millimetres();
  const bool isTurned = this->Up == 1;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    checked->GetPoint(i, p);
    const double x = p[0] - box[0];
    isTurned ? points->SetPoint(i, unit * x, unit * (box[5] - p[2]), unit * (p[1] - box[2]))
             : points->SetPoint(i, unit * x, unit * (p[1] - box[2]), unit * (p[2] - box[4]));
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(checked->GetPolys());
  if (vtkDataArray* parts = checked->GetCellData()->GetArray("PartId"))
  {
    mesh->GetCellData()->AddArray(parts);
  }
  return mesh;
}

} // namespace oversketch_studio
