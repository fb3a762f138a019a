package main

import (
	"math"

	"adit/scene"
	"adit/wire"
)

// Equal rectangular zones between grid points, explicit finite differences. A zone has one mean strain and two
// bending stresses, as Pian and Sumihara (1984) assume them. Vectors hold x and y of each grid point in turn.
type Grid struct {
	continuum              *scene.Continuum
	block                  *scene.Block
	across, up             int     // zones
	lx, ly                 float64 // of a zone [m]
	d11, d12, shear, young float64 // stiffness in the plane [Pa]; young: that of a strip in bending
	density                float64

	weight []float64 // of zones; 0: it does not exist
	mass   []float64 // of grid points [kg]; 0: no zone is left there

	loads     []Load
	bodyLoads []BodyLoad
	motions   map[int]*Motion // by component

	u, v    []float64 // u(n), v(n + 1/2)
	before  []float64 // v(n - 1/2), corrected; 0 at step 0
	force   []float64 // of stresses and loads
	outside []float64 // loads and reactions, which do work
	kick    float64   // time over which forces of the last step changed velocities [s]
	work    float64   // of all but the last half step
	strain  float64   // energy

	rows [][]entry // of the coupling points
}

type Load struct {
	shares map[int]float64 // of grid points
	force  *scene.Force
	time   *scene.TimeFunction
}

type BodyLoad struct {
	points       []int
	acceleration *scene.Acceleration
	time         *scene.TimeFunction
}

type Motion struct {
	velocity float64
	time     *scene.TimeFunction
}

type edge struct {
	from, to int
	length   float64
}

type entry struct {
	point int
	value float64
}

func newGrid(continuum *scene.Continuum, material *scene.Material, plane scene.Plane) *Grid {
	block := continuum.Block
	across, up := int(block.GetZonesX()), int(block.GetZonesY())
	g := &Grid{continuum: continuum, block: block, across: across, up: up, density: material.GetDensity()}
	g.lx = (block.GetXMax() - block.GetXMin()) / float64(across)
	g.ly = (block.GetYMax() - block.GetYMin()) / float64(up)
	e, nu := material.GetYoungModulus(), material.GetPoissonRatio()
	g.shear = e / (2 * (1 + nu))
	if plane == scene.Plane_PLANE_STRAIN {
		e, nu = e/(1-nu*nu), nu/(1-nu)
	}
	g.young, g.d11, g.d12 = e, e/(1-nu*nu), nu*e/(1-nu*nu)
	components := 2 * g.points()
	g.u, g.v, g.before = make([]float64, components), make([]float64, components), make([]float64, components)
	g.force, g.outside = make([]float64, components), make([]float64, components)
	return g
}

func (g *Grid) points() int { return (g.across + 1) * (g.up + 1) }

func (g *Grid) place(point int) (x, y float64) {
	i, j := point%(g.across+1), point/(g.across+1)
	x = g.block.GetXMin() + (g.block.GetXMax()-g.block.GetXMin())*float64(i)/float64(g.across)
	y = g.block.GetYMin() + (g.block.GetYMax()-g.block.GetYMin())*float64(j)/float64(g.up)
	return x, y
}

// Corners of a zone, counter-clockwise from the lower left one.
func (g *Grid) corners(zone int) [4]int {
	first := zone/g.across*(g.across+1) + zone%g.across
	return [4]int{first, first + 1, first + g.across + 2, first + g.across + 1}
}

// Edges of the block whose zones exist.
func (g *Grid) boundary() (edges []edge) {
	add := func(zone, side int, length float64) {
		if g.exists(zone) {
			corners := g.corners(zone)
			edges = append(edges, edge{corners[side], corners[(side+1)%4], length})
		}
	}
	for i := 0; i < g.across; i++ {
		add(i, 0, g.lx)
		add((g.up-1)*g.across+i, 2, g.lx)
	}
	for j := 0; j < g.up; j++ {
		add(j*g.across, 3, g.ly)
		add(j*g.across+g.across-1, 1, g.ly)
	}
	return edges
}

// Before the weights have come, all of the grid exists.
func (g *Grid) exists(zone int) bool { return g.weight == nil || g.weight[zone] > 0 }

// Places are compared within 1e-9 of the model's size.
func (g *Grid) tolerance() float64 {
	return 1e-9 * math.Max(g.lx*float64(g.across), g.ly*float64(g.up))
}

func (g *Grid) pointsIn(area *scene.Area) (points []int) {
	inside := func(value float64, least, most *float64) bool {
		return (least == nil || value >= *least-g.tolerance()) && (most == nil || value <= *most+g.tolerance())
	}
	for point := 0; point < g.points(); point++ {
		x, y := g.place(point)
		exists := g.mass == nil || g.mass[point] > 0
		if exists && (area == nil || inside(x, area.XMin, area.XMax) && inside(y, area.YMin, area.YMax)) {
			points = append(points, point)
		}
	}
	return points
}

// Shape functions of a zone that exists and holds the place, at its corners.
func (g *Grid) locate(x, y float64) (corners [4]int, shape [4]float64, inside bool) {
	right := (x - g.block.GetXMin()) / g.lx
	above := (y - g.block.GetYMin()) / g.ly
	slackX, slackY := g.tolerance()/g.lx, g.tolerance()/g.ly
	// A place on a side belongs to the zones of both sides, of which one may be gone.
	for _, i := range []float64{math.Floor(right + slackX), math.Floor(right - slackX)} {
		for _, j := range []float64{math.Floor(above + slackY), math.Floor(above - slackY)} {
			if !(i >= 0 && i < float64(g.across) && j >= 0 && j < float64(g.up)) {
				continue
			}
			zone := int(j)*g.across + int(i)
			if !g.exists(zone) {
				continue
			}
			s := math.Min(math.Max(right-i, 0), 1)
			t := math.Min(math.Max(above-j, 0), 1)
			return g.corners(zone), [4]float64{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}, true
		}
	}
	return corners, shape, false
}

// A zone with its quarter of the mass at each corner cannot oscillate faster than this, however it is weighted; no
// grid of such zones oscillates faster than its fastest zone.
func (g *Grid) criticalStep() float64 {
	a, b := 4/(g.density*g.lx*g.lx), 4/(g.density*g.ly*g.ly)
	half := g.d11 * (a + b) / 2
	stretch := half + math.Sqrt(math.Pow(g.d11*(a-b)/2, 2)+g.d12*g.d12*a*b)
	return 2 / math.Sqrt(math.Max(stretch, g.shear*(a+b)))
}

func (g *Grid) model() *wire.Model {
	m := &wire.Model{CriticalDt: g.criticalStep(), XMin: g.block.GetXMin(), XMax: g.block.GetXMax(),
		YMin: g.block.GetYMin(), YMax: g.block.GetYMax(), CriticalElement: "zone",
		PWaveSpeed: math.Sqrt(g.d11 / g.density), SWaveSpeed: math.Sqrt(g.shear / g.density)}
	m.CriticalX, m.CriticalY = m.XMin+g.lx/2, m.YMin+g.ly/2
	for point := 0; point < g.points(); point++ {
		x, y := g.place(point)
		m.SamplePoints = append(m.SamplePoints, x, y)
	}
	return m
}

// Zones weigh the mean of their corners, which is exact for a linear weight.
func (g *Grid) weigh(request *wire.Weights) (*wire.Interface, error) {
	samples := request.Weights
	if len(samples) != 0 && len(samples) != g.points() {
		return nil, requestFault("%d weights for %d sample points", len(samples), g.points())
	}
	for _, sample := range samples {
		if sample < 0 || sample > 1 {
			return nil, requestFault("weight %g is not between 0 and 1", sample)
		}
	}
	if len(samples) != 0 && !(request.Floor > 0 && request.Floor <= 1) {
		return nil, requestFault("floor %g is not above 0 and at most 1", request.Floor)
	}
	g.weight, g.mass = make([]float64, g.across*g.up), make([]float64, g.points())
	answer := &wire.Interface{}
	for zone := range g.weight {
		g.weight[zone] = 1
		if len(samples) != 0 {
			sum := 0.0
			for _, corner := range g.corners(zone) {
				sum += samples[corner]
			}
			if sum == 0 {
				g.weight[zone] = 0
				continue
			}
			g.weight[zone] = math.Max(request.Floor, sum/4)
		}
		answer.Zones++
		for _, corner := range g.corners(zone) {
			g.mass[corner] += g.weight[zone] * g.density * g.lx * g.ly / 4
		}
	}
	if answer.Zones == 0 {
		return nil, sceneFault("interface.overlap", "leaves no zone of the grid")
	}
	for point, mass := range g.mass {
		if mass == 0 {
			continue
		}
		answer.GridPoints++
		answer.Mass += mass
		x, y := g.place(point)
		if len(samples) != 0 && x >= request.XMin && x <= request.XMax && y >= request.YMin && y <= request.YMax {
			answer.Points = append(answer.Points, x, y)
		}
	}
	return answer, g.selectPlaces()
}

func (g *Grid) couple(places []float64) (*wire.Operator, error) {
	offered := map[[2]uint64]int{}
	for point, mass := range g.mass {
		if x, y := g.place(point); mass > 0 {
			offered[[2]uint64{math.Float64bits(x), math.Float64bits(y)}] = point
		}
	}
	answer := &wire.Operator{RowStarts: []uint32{0}}
	columns := map[int]uint32{}
	add := func(point int, value float64) entry {
		column, known := columns[point]
		if !known {
			column = uint32(len(columns))
			columns[point] = column
			for component := 2 * point; component < 2*point+2; component++ {
				inverse := 1 / g.mass[point]
				if g.motions[component] != nil {
					inverse = 0
				}
				answer.InverseMasses = append(answer.InverseMasses, inverse)
			}
		}
		answer.Columns = append(answer.Columns, column)
		answer.Values = append(answer.Values, value)
		return entry{point, value}
	}
	for k := 0; k+1 < len(places); k += 2 {
		x, y := places[k], places[k+1]
		var row []entry
		if point, own := offered[[2]uint64{math.Float64bits(x), math.Float64bits(y)}]; own {
			row = []entry{add(point, 1)}
		} else {
			corners, shape, inside := g.locate(x, y)
			if !inside {
				return nil, sceneFault("interface.overlap", "the coupling point (%g, %g) lies in no zone", x, y)
			}
			for i, value := range shape {
				if value != 0 {
					row = append(row, add(corners[i], value))
				}
			}
		}
		g.rows = append(g.rows, row)
		answer.RowStarts = append(answer.RowStarts, uint32(len(answer.Columns)))
	}
	return answer, nil
}

// Impulses of the step before correct its velocities; where the motion is prescribed, the reaction bears them.
func (g *Grid) correct(impulses []float64) {
	if len(impulses) == 0 {
		return
	}
	for k, row := range g.rows {
		for _, e := range row {
			for c := 0; c < 2; c++ {
				component, impulse := 2*e.point+c, e.value*impulses[2*k+c]
				if g.motions[component] != nil {
					g.outside[component] -= impulse / g.kick
				} else {
					g.v[component] += impulse / g.mass[e.point]
				}
			}
		}
	}
}

func (g *Grid) advance(step uint64, dt float64) error {
	if step > 0 {
		// Reactions of the step before are known only now that they bear its impulses.
		for i, force := range g.outside {
			g.work += dt / 2 * (g.before[i] + g.v[i]) * force
			g.u[i] += dt * g.v[i]
		}
	}
	copy(g.before, g.v)
	g.applyLoads(float64(step) * dt)
	g.addStresses()
	g.kick = dt
	if step == 0 {
		g.kick = dt / 2
	}
	for i, force := range g.force {
		mass := g.mass[i/2]
		if mass == 0 {
			continue
		}
		if motion := g.motions[i]; motion != nil {
			g.v[i] = motion.velocity * factor(motion.time, (float64(step)+0.5)*dt)
			g.outside[i] += mass*(g.v[i]-g.before[i])/dt - force
		} else {
			g.v[i] += g.kick * force / mass
		}
		if !isFinite(g.v[i]) {
			x, y := g.place(i / 2)
			return fault{wire.Error_UNSTABLE, "", unstable(step, x, y, g.v[i])}
		}
	}
	return nil
}

func (g *Grid) applyLoads(time float64) {
	for i := range g.outside {
		g.outside[i] = 0
	}
	for _, load := range g.loads {
		f := factor(load.time, time)
		for point, share := range load.shares {
			g.outside[2*point] += share * f * load.force.GetX()
			g.outside[2*point+1] += share * f * load.force.GetY()
		}
	}
	for _, load := range g.bodyLoads {
		f := factor(load.time, time)
		for _, point := range load.points {
			g.outside[2*point] += g.mass[point] * f * load.acceleration.GetX()
			g.outside[2*point+1] += g.mass[point] * f * load.acceleration.GetY()
		}
	}
	copy(g.force, g.outside)
}

func (g *Grid) addStresses() {
	signX, signY := [4]float64{-1, 1, 1, -1}, [4]float64{-1, -1, 1, 1}
	area := g.lx * g.ly
	bendX, bendY := 4*g.young*area/(3*g.lx*g.lx), 4*g.young*area/(3*g.ly*g.ly)
	g.strain = 0
	for zone, weight := range g.weight {
		if weight == 0 {
			continue
		}
		corners := g.corners(zone)
		var exx, eyy, gxy, hx, hy float64
		for i, corner := range corners {
			bx, by := signX[i]/(2*g.lx), signY[i]/(2*g.ly)
			ux, uy := g.u[2*corner], g.u[2*corner+1]
			exx += bx * ux
			eyy += by * uy
			gxy += by*ux + bx*uy
			hx += signX[i] * signY[i] * ux / 4
			hy += signX[i] * signY[i] * uy / 4
		}
		sxx, syy, sxy := g.d11*exx+g.d12*eyy, g.d12*exx+g.d11*eyy, g.shear*gxy
		g.strain += weight / 2 * (area*(sxx*exx+syy*eyy+sxy*gxy) + bendX*hx*hx + bendY*hy*hy)
		for i, corner := range corners {
			bx, by := signX[i]/(2*g.lx), signY[i]/(2*g.ly)
			twist := signX[i] * signY[i] / 4
			g.force[2*corner] -= weight * (area*(sxx*bx+sxy*by) + bendX*hx*twist)
			g.force[2*corner+1] -= weight * (area*(sxy*bx+syy*by) + bendY*hy*twist)
		}
	}
}

func (g *Grid) velocities() (answer []float64) {
	for _, row := range g.rows {
		x, y := 0.0, 0.0
		for _, e := range row {
			x += e.value * g.v[2*e.point]
			y += e.value * g.v[2*e.point+1]
		}
		answer = append(answer, x, y)
	}
	return answer
}

func (g *Grid) energies(step uint64, dt float64) *wire.Energies {
	answer := &wire.Energies{Strain: g.strain, ExternalWork: g.work}
	for i, v := range g.v {
		if step == 0 {
			if g.motions[i] == nil { // what is prescribed comes to its velocity at once, from v(-1/2) = 0
				answer.Kinetic -= g.mass[i/2] * v * v / 2
			}
		} else {
			answer.Kinetic += g.mass[i/2] * g.before[i] * v / 2
			answer.ExternalWork += dt / 2 * g.before[i] * g.outside[i]
		}
	}
	return answer
}

func (g *Grid) historyValues() (values []float64) {
	for _, history := range g.continuum.Histories {
		corners, shape, _ := g.locate(history.At.GetX(), history.At.GetY())
		field, component := g.u, int(history.GetQuantity())%2
		if history.GetQuantity() >= scene.Quantity_VELOCITY_X {
			field = g.before
		}
		value := 0.0
		for i, corner := range corners {
			value += shape[i] * field[2*corner+component]
		}
		values = append(values, value)
	}
	return values
}

func (g *Grid) snapshot() *wire.Snapshot {
	piece := &wire.Piece{Name: "grid", Shape: wire.Piece_QUADS}
	displacement := &wire.Field{Name: "displacement_m", Components: 2}
	velocity := &wire.Field{Name: "velocity_m_per_s", Components: 2}
	number := make([]uint32, g.points())
	for point, mass := range g.mass {
		if mass == 0 {
			continue
		}
		number[point] = uint32(len(piece.Points) / 2)
		x, y := g.place(point)
		piece.Points = append(piece.Points, x, y)
		displacement.Values = append(displacement.Values, g.u[2*point], g.u[2*point+1])
		velocity.Values = append(velocity.Values, g.v[2*point], g.v[2*point+1])
	}
	weight := &wire.Field{Name: "weight", Components: 1}
	for zone, w := range g.weight {
		if w == 0 {
			continue
		}
		for _, corner := range g.corners(zone) {
			piece.Connectivity = append(piece.Connectivity, number[corner])
		}
		weight.Values = append(weight.Values, w)
	}
	piece.PointFields = []*wire.Field{displacement, velocity}
	piece.CellFields = []*wire.Field{weight}
	return &wire.Snapshot{Pieces: []*wire.Piece{piece}}
}
