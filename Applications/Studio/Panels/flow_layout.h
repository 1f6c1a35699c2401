// Widgets one beside the other, in as many lines as the width asks for.
#ifndef oversketch_applications_studio_panels_flow_layout_h
#define oversketch_applications_studio_panels_flow_layout_h

#include <QLayout>
#include <QVector>

namespace oversketch_studio
{

class FlowLayout : public QLayout
{
public:
  using QLayout::QLayout;
  ~FlowLayout() override { qDeleteAll(this->Items); }

  void addItem(QLayoutItem* item) override { this->Items << item; }
  int count() const override { return this->Items.size(); }
  QLayoutItem* itemAt(int index) const override { return this->Items.value(index); }
  QLayoutItem* takeAt(int index) override
  {
    return index < 0 || index >= this->Items.size() ? nullptr : this->Items.takeAt(index);
  }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return this->arrange({ 0, 0, width, 0 }, false); }
  Qt::Orientations expandingDirections() const override { return {}; }
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& place) override;

private:
  // Returns the height; with `moves` the widgets are put there.
  int arrange(const QRect& place, bool moves) const;

  QVector<QLayoutItem*> Items;
};

} // namespace oversketch_studio
#endif
