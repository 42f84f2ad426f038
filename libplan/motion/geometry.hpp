// Plane geometry of motions: points, segments, oriented boxes, polygons. y grows southwards.
#pragma once
#include <array>
#include <vector>

namespace waymark::plan {

struct Point {
  double x = 0, y = 0;  // in the plane
  friend bool operator==(const Point&, const Point&) = default;
};
double distance(Point a, Point b);                    // Euclidean
double distance(Point p, Point a, Point b);           // from p to the segment ab
double distance(Point a, Point b, Point c, Point d);  // between the segments ab and cd

// Twice the area of the triangle abc, positive when it is walked clockwise on the page.
double orientation(Point a, Point b, Point c);

using Box = std::array<Point, 4>;              // the corners of a rectangle, one after the other
bool contains(const Box& box, Point p);        // borders included
double gap(const Box& box, Point p);           // 0 inside
double gap(const Box& box, Point a, Point b);  // to the segment ab, 0 where they meet

using Polygon = std::vector<Point>;              // closed: the last corner is joined to the first
bool contains(const Polygon& polygon, Point p);  // on the border either answer
double signed_area(const Polygon& polygon);      // positive when walked clockwise on the page
bool meets_itself(const Polygon& polygon);       // two edges that are no neighbours touch, or neighbours overlap

// Where the lines of two segments that cross or touch meet; the segments must not be parallel.
Point meeting(Point a, Point b, Point c, Point d);

}  // namespace waymark::plan
