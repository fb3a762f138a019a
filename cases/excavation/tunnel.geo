// A tunnel of 10 m across, 20 m below the surface; its top heading and its bench are surfaces of their own.
//   gmsh -2 tunnel.geo        makes tunnel.msh (Gmsh 4.8, Debian package `gmsh`)
Mesh.MshFileVersion = 4.1;
Mesh.RecombineAll = 1;
Mesh.Algorithm = 6;
Mesh.SubdivisionAlgorithm = 1;  // quadrilaterals only; halves the sizes below

r = 5;  fine = 2;  coarse = 10;
Point(1) = {-50, -40, 0, coarse};  Point(2) = {50, -40, 0, coarse};
Point(3) = {50, 25, 0, coarse};    Point(4) = {-50, 25, 0, coarse};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};

Point(5) = {0, 0, 0, fine};
Point(6) = {r, 0, 0, fine};  Point(7) = {0, r, 0, fine};  Point(8) = {-r, 0, 0, fine};  Point(9) = {0, -r, 0, fine};
Circle(5) = {6, 5, 7};  Circle(6) = {7, 5, 8};  Circle(7) = {8, 5, 9};  Circle(8) = {9, 5, 6};
Line(9) = {8, 5};  Line(10) = {5, 6};

Curve Loop(1) = {1, 2, 3, 4};  Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};
Curve Loop(3) = {5, 6, 9, 10};   Plane Surface(2) = {3};
Curve Loop(4) = {7, 8, -10, -9}; Plane Surface(3) = {4};

Physical Surface("ground") = {1};
Physical Surface("heading") = {2};
Physical Surface("bench") = {3};
Physical Curve("wall") = {5, 6, 7, 8};
Physical Curve("base") = {1};
Physical Curve("sides") = {2, 4};
