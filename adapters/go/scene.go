package main

import (
	"fmt"
	"math"
	"sort"
	"strings"
	"unicode/utf8"

	"adit/scene"
	"adit/wire"

	"google.golang.org/protobuf/proto"
	"google.golang.org/protobuf/reflect/protoreflect"
)

// What of a scene this participant computes. Hello lists it, and any other key is refused.
var computes = func() []string {
	keys := []string{"name", "description", "plane", "time", "continuum.block", "continuum.zone.assumed_strain",
		"continuum.body_loads.acceleration", "continuum.body_loads.time", "continuum.motions.velocity",
		"continuum.motions.time", "continuum.histories.name", "continuum.histories.at"}
	for _, material := range []string{"material", "continuum.material"} {
		for _, constant := range []string{"young_modulus", "poisson_ratio", "density"} {
			keys = append(keys, material+"."+constant)
		}
	}
	for _, list := range []string{"point_loads", "edge_loads"} {
		keys = append(keys, "continuum."+list+".force", "continuum."+list+".time")
	}
	for _, list := range []string{"point_loads", "edge_loads", "body_loads", "motions"} {
		for _, side := range []string{"x_min", "x_max", "y_min", "y_max"} {
			keys = append(keys, "continuum."+list+".where."+side)
		}
	}
	for _, quantity := range []string{"displacement_x", "displacement_y", "velocity_x", "velocity_y"} {
		keys = append(keys, "continuum.histories.quantity."+quantity)
	}
	return keys
}()

// A fault that ends the run and is told to the coupler.
type fault struct {
	kind    wire.Error_Kind
	path    string
	message string
}

func (f fault) Error() string { return f.message }

func sceneFault(path, format string, values ...interface{}) error {
	return fault{wire.Error_SCENE, path, fmt.Sprintf(format, values...)}
}

func requestFault(format string, values ...interface{}) error {
	return fault{wire.Error_REQUEST, "", fmt.Sprintf(format, values...)}
}

func isListed(key string) bool {
	for _, listed := range computes {
		if key == listed || strings.HasPrefix(key, listed+".") {
			return true
		}
	}
	return false
}

func holdsListed(key string) bool {
	for _, listed := range computes {
		if strings.HasPrefix(listed, key+".") {
			return true
		}
	}
	return isListed(key)
}

// Refuses every key of the message that is not computed. `key` is the path as hello lists it, `place` the same with
// numbers of list elements, for the user.
func refuseOthers(message protoreflect.Message, key, place string) (err error) {
	if len(message.GetUnknown()) > 0 {
		return sceneFault(place, "a key of a newer release is not computed here")
	}
	message.Range(func(field protoreflect.FieldDescriptor, value protoreflect.Value) bool {
		fieldKey, fieldPlace := join(key, string(field.Name())), join(place, string(field.Name()))
		if !field.IsList() {
			err = refuseOther(field, value, fieldKey, fieldPlace)
			return err == nil
		}
		for i := 0; i < value.List().Len() && err == nil; i++ {
			err = refuseOther(field, value.List().Get(i), fieldKey, fmt.Sprintf("%s[%d]", fieldPlace, i))
		}
		return err == nil
	})
	return err
}

func refuseOther(field protoreflect.FieldDescriptor, value protoreflect.Value, key, place string) error {
	refusal := sceneFault(place, "this participant does not compute it")
	switch field.Kind() {
	case protoreflect.MessageKind:
		if !holdsListed(key) {
			return refusal
		}
		return refuseOthers(value.Message(), key, place)
	case protoreflect.EnumKind:
		name := field.Enum().Values().ByNumber(value.Enum())
		if name == nil || !isListed(key+"."+strings.ToLower(string(name.Name()))) && value.Enum() != field.Default().Enum() {
			return refusal
		}
	case protoreflect.StringKind:
		if !utf8.ValidString(value.String()) {
			return requestFault("%s is not valid UTF-8", place)
		}
		fallthrough
	default:
		isDefault := !field.IsList() && field.HasDefault() && value.Interface() == field.Default().Interface()
		if !isListed(key) && !isDefault {
			return refusal
		}
	}
	return nil
}

func join(path, name string) string {
	if path == "" {
		return name
	}
	return path + "." + name
}

// Refuses numbers that are not finite, wherever they stand in a request. An absent end of a sine is no number sent.
func refuseNotFinite(message protoreflect.Message) (err error) {
	message.Range(func(field protoreflect.FieldDescriptor, value protoreflect.Value) bool {
		check := func(value protoreflect.Value) {
			if field.Kind() == protoreflect.MessageKind {
				err = refuseNotFinite(value.Message())
			} else if field.Kind() == protoreflect.DoubleKind && !isFinite(value.Float()) &&
				!(field.HasDefault() && value.Float() == field.Default().Float()) {
				err = requestFault("%s is not finite", field.Name())
			}
		}
		if !field.IsList() {
			check(value)
			return err == nil
		}
		for i := 0; i < value.List().Len() && err == nil; i++ {
			check(value.List().Get(i))
		}
		return err == nil
	})
	return err
}

func isFinite(x float64) bool { return !math.IsInf(x, 0) && !math.IsNaN(x) }

// The factor of a load or a motion at a time.
func factor(function *scene.TimeFunction, time float64) float64 {
	switch shape := function.GetShape().(type) {
	case *scene.TimeFunction_Constant:
		return shape.Constant
	case *scene.TimeFunction_Sine:
		if time > shape.Sine.GetEnd() {
			return 0
		}
		return math.Sin(2*math.Pi*shape.Sine.GetFrequency()*time + shape.Sine.GetPhase())
	case *scene.TimeFunction_Table:
		times, values := shape.Table.Time, shape.Table.Value
		next := sort.SearchFloat64s(times, time)
		if next == 0 {
			return values[0]
		}
		if next == len(times) {
			return values[next-1]
		}
		share := (time - times[next-1]) / (times[next] - times[next-1])
		return values[next-1] + share*(values[next]-values[next-1])
	}
	return 1
}

func checkTable(function *scene.TimeFunction, place string) error {
	table := function.GetTable()
	if table == nil {
		return nil
	}
	if len(table.Time) == 0 || len(table.Time) != len(table.Value) || !sort.Float64sAreSorted(table.Time) {
		return sceneFault(place+".time.table", "needs as many values as times, which grow")
	}
	return nil
}

// The scene's continuum as a grid; whatever this participant does not compute is refused.
func build(s *scene.Scene) (*Grid, error) {
	if s == nil {
		return nil, requestFault("setup without a scene")
	}
	if err := refuseOthers(s.ProtoReflect(), "", ""); err != nil {
		return nil, err
	}
	continuum := s.GetContinuum()
	block := continuum.GetBlock()
	if block == nil {
		return nil, sceneFault("continuum.block", "required: this participant computes a block of equal zones")
	}
	width, height := block.GetXMax()-block.GetXMin(), block.GetYMax()-block.GetYMin()
	if !(width > 0) || !(height > 0) || block.GetZonesX() == 0 || block.GetZonesY() == 0 {
		return nil, sceneFault("continuum.block", "needs x_max above x_min, y_max above y_min, and zones")
	}
	const mostZones = 4e6 // some 1 GiB
	if float64(block.GetZonesX())*float64(block.GetZonesY()) > mostZones {
		return nil, sceneFault("continuum.block", "has more than %.0f zones", mostZones)
	}
	place, material := "material", s.GetMaterial()
	if continuum.Material != nil {
		place, material = "continuum.material", continuum.Material
	}
	if !(material.GetYoungModulus() > 0) || !(material.GetDensity() > 0) || material.PoissonRatio == nil ||
		!(material.GetPoissonRatio() > -1) || !(material.GetPoissonRatio() < 0.5) {
		return nil, sceneFault(place, "needs young_modulus and density above 0, poisson_ratio above -1 and below 0.5")
	}
	for _, list := range [][]timed{timedOf(continuum.PointLoads, "point_loads"), timedOf(continuum.EdgeLoads, "edge_loads"),
		timedOf(continuum.BodyLoads, "body_loads"), timedOf(continuum.Motions, "motions")} {
		for _, one := range list {
			table := one.function.GetTable()
			if table != nil && (len(table.Time) == 0 || len(table.Time) != len(table.Value) || !increases(table.Time)) {
				return nil, sceneFault(one.place+".time.table", "needs as many values as times, which increase")
			}
		}
	}
	for i, history := range continuum.GetHistories() {
		if history.At == nil {
			return nil, sceneFault(fmt.Sprintf("continuum.histories[%d].at", i), "required")
		}
	}
	grid := newGrid(continuum, material, s.GetPlane())
	return grid, grid.selectPlaces()
}

type timed struct {
	place    string
	function *scene.TimeFunction
}

func timedOf[Item interface{ GetTime() *scene.TimeFunction }](items []Item, name string) (all []timed) {
	for i, item := range items {
		all = append(all, timed{fmt.Sprintf("continuum.%s[%d]", name, i), item.GetTime()})
	}
	return all
}

func increases(values []float64) bool {
	for i := range values {
		if i > 0 && values[i] <= values[i-1] {
			return false
		}
	}
	return true
}

// Finds what the scene's areas and places select: at setup in the whole grid, then in what the overlap leaves of it,
// which bears the whole of each load.
func (g *Grid) selectPlaces() error {
	g.loads, g.bodyLoads, g.motions = nil, nil, map[int]*Motion{}
	for i, load := range g.continuum.PointLoads {
		points := g.pointsIn(load.Where)
		shares := map[int]float64{}
		for _, point := range points {
			shares[point] = 1 / float64(len(points))
		}
		if err := g.addLoad(load, shares, fmt.Sprintf("continuum.point_loads[%d]", i)); err != nil {
			return err
		}
	}
	for i, load := range g.continuum.EdgeLoads {
		selected := map[int]bool{}
		for _, point := range g.pointsIn(load.Where) {
			selected[point] = true
		}
		shares, sum := map[int]float64{}, 0.0
		for _, edge := range g.boundary() {
			if selected[edge.from] && selected[edge.to] {
				shares[edge.from] += edge.length / 2
				shares[edge.to] += edge.length / 2
				sum += edge.length
			}
		}
		for point := range shares {
			shares[point] /= sum
		}
		if err := g.addLoad(load, shares, fmt.Sprintf("continuum.edge_loads[%d]", i)); err != nil {
			return err
		}
	}
	for i, load := range g.continuum.BodyLoads {
		points := g.pointsIn(load.Where)
		if len(points) == 0 {
			return sceneFault(fmt.Sprintf("continuum.body_loads[%d].where", i), "selects no grid point")
		}
		g.bodyLoads = append(g.bodyLoads, BodyLoad{points, load.Acceleration, load.Time})
	}
	for i, motion := range g.continuum.Motions {
		place := fmt.Sprintf("continuum.motions[%d]", i)
		points := g.pointsIn(motion.Where)
		if len(points) == 0 {
			return sceneFault(place+".where", "selects no grid point")
		}
		for _, point := range points {
			for c, velocity := range []*float64{motion.GetVelocity().X, motion.GetVelocity().Y} {
				if velocity == nil {
					continue
				}
				if g.motions[2*point+c] != nil {
					return sceneFault(place+".velocity", "moves a grid point that another motion moves, too")
				}
				g.motions[2*point+c] = &Motion{*velocity, motion.Time}
			}
		}
	}
	for i, history := range g.continuum.Histories {
		if _, _, inside := g.locate(history.At.GetX(), history.At.GetY()); !inside {
			return sceneFault(fmt.Sprintf("continuum.histories[%d].at", i), "lies in no zone")
		}
	}
	return nil
}

func (g *Grid) addLoad(load *scene.Load, shares map[int]float64, place string) error {
	if len(shares) == 0 {
		return sceneFault(place+".where", "selects nothing")
	}
	g.loads = append(g.loads, Load{shares, load.Force, load.Time})
	return nil
}

func finite(message proto.Message) error { return refuseNotFinite(message.ProtoReflect()) }
