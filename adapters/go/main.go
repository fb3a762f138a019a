// A participant for `continuum`, written from docs/protocol.md: a block of equal elastic zones.
//
//	grid --listen 127.0.0.1:4711
package main

import (
	"flag"
	"fmt"
	"net"
	"os"
	"sync"
	"time"

	"adit/wire"

	"google.golang.org/protobuf/proto"
)

const release = "1"

// A client may come before the end of the one that has just closed was noticed.
const grace = 500 * time.Millisecond

func main() {
	address := flag.String("listen", "127.0.0.1:0", "HOST:PORT")
	flag.Parse()
	listener, err := net.Listen("tcp", *address)
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
	fmt.Println("listening on", listener.Addr())
	place := make(chan struct{}, 1)
	for {
		socket, err := listener.Accept()
		if err != nil {
			fmt.Fprintln(os.Stderr, err)
			os.Exit(1)
		}
		go func() {
			c := newConnection(socket)
			select {
			case place <- struct{}{}:
				var once sync.Once
				serve(c, func() { once.Do(func() { <-place }) })
			case <-time.After(grace):
				c.fail(fault{wire.Error_REFUSED, "", "busy with another run, try again later"})
			}
		}()
	}
}

// One run. The place is free for the next one before the client learns that this one has ended.
func serve(c *connection, free func()) {
	defer free()
	defer func() {
		if bug := recover(); bug != nil {
			free()
			c.fail(fault{wire.Error_INTERNAL, "", fmt.Sprint(bug)})
		}
	}()
	err := converse(c, free)
	free()
	if err != nil {
		c.fail(err)
	}
}

type state int

const (
	connected state = iota
	setUp
	weighed
	coupled
	running
)

func converse(c *connection, free func()) error {
	if err := c.greet(); err != nil {
		return err
	}
	go c.beat()
	go c.read()
	r := &run{}
	for {
		request, err := c.next(r.patience())
		if err != nil {
			return err
		}
		if err := finite(request); err != nil {
			return err
		}
		if _, last := request.Content.(*wire.Frame_Finish); last && r.state != connected {
			free()
			bye := &wire.Bye{CpuSeconds: r.computing.Seconds()}
			if r.next > 0 { // step 0 does not move
				bye.Updates = (r.next - 1) * r.zones
			}
			return c.farewell(bye)
		}
		answer, err := r.answer(request)
		if err != nil {
			return err
		}
		c.accept(r.longest())
		if err := c.send(answer); err != nil {
			return err
		}
	}
}

// What is known of a run between two requests.
type run struct {
	state     state
	alone     bool
	corrected bool // the step reached had its impulses
	grid      *Grid
	zones     uint64
	next      uint64 // step
	dt        float64
	computing time.Duration
}

func (r *run) patience() time.Duration {
	switch r.state {
	case connected:
		return 10 * time.Second
	case setUp:
		return 25 * time.Hour
	}
	return time.Hour
}

// The longest request that may come now [bytes].
func (r *run) longest() uint64 {
	if r.state == setUp {
		return longestRequest + 8*uint64(r.grid.points())
	}
	return longestRequest + 16*uint64(len(r.grid.rows))
}

func (r *run) answer(request *wire.Frame) (*wire.Frame, error) {
	begin := time.Now()
	defer func() { r.computing += time.Since(begin) }()
	switch content := request.Content.(type) {
	case *wire.Frame_Setup:
		if r.state != connected {
			break
		}
		grid, err := build(content.Setup.Scene)
		if err != nil {
			return nil, err
		}
		r.grid, r.state = grid, setUp
		return &wire.Frame{Content: &wire.Frame_Model{Model: grid.model()}}, nil
	case *wire.Frame_Weights:
		if r.state != setUp {
			break
		}
		answer, err := r.grid.weigh(content.Weights)
		if err != nil {
			return nil, err
		}
		r.state, r.alone, r.zones = weighed, len(content.Weights.Weights) == 0, answer.Zones
		return &wire.Frame{Content: &wire.Frame_Interface{Interface: answer}}, nil
	case *wire.Frame_Couple:
		if r.state != weighed || r.alone {
			break
		}
		if len(content.Couple.Points)%2 != 0 {
			return nil, requestFault("a coupling point without y")
		}
		answer, err := r.grid.couple(content.Couple.Points)
		if err != nil {
			return nil, err
		}
		r.state = coupled
		return &wire.Frame{Content: &wire.Frame_Operator{Operator: answer}}, nil
	case *wire.Frame_Advance:
		if r.state < weighed {
			break
		}
		answer, err := r.advance(content.Advance)
		if err != nil {
			return nil, err
		}
		answer.ComputeSeconds = time.Since(begin).Seconds()
		return &wire.Frame{Content: &wire.Frame_Predicted{Predicted: answer}}, nil
	case *wire.Frame_SnapshotRequest:
		if r.state < weighed {
			break
		}
		if err := r.correct(content.SnapshotRequest.Impulses); err != nil {
			return nil, err
		}
		return &wire.Frame{Content: &wire.Frame_Snapshot{Snapshot: r.grid.snapshot()}}, nil
	}
	return nil, requestFault("%T came out of order", request.Content)
}

func (r *run) correct(impulses []float64) error {
	if len(impulses) == 0 {
		return nil
	}
	if len(impulses) != 2*len(r.grid.rows) {
		return requestFault("%d impulses for %d coupling points", len(impulses), len(r.grid.rows))
	}
	if r.next == 0 || r.corrected {
		return requestFault("impulses where no step waits for them")
	}
	r.corrected = true
	r.grid.correct(impulses)
	return nil
}

func (r *run) advance(request *wire.Advance) (*wire.Predicted, error) {
	if request.Relax || request.Stop || request.Stage != 0 || request.LocalDamping != 0 ||
		request.DriftX != 0 || request.DriftY != 0 {
		return nil, requestFault("this scene has no statics")
	}
	if request.Step != r.next {
		return nil, requestFault("advance to step %d, where %d is next", request.Step, r.next)
	}
	if !(request.Dt > 0) || r.next > 0 && request.Dt != r.dt {
		return nil, requestFault("dt %g is not positive, or not that of the steps before", request.Dt)
	}
	if err := r.correct(request.Impulses); err != nil {
		return nil, err
	}
	if err := r.grid.advance(request.Step, request.Dt); err != nil {
		return nil, err
	}
	r.state, r.corrected, r.dt, r.next = running, false, request.Dt, r.next+1
	answer := &wire.Predicted{Step: request.Step, Velocities: r.grid.velocities()}
	if request.WantEnergies {
		answer.Energies = r.grid.energies(request.Step, request.Dt)
	}
	if request.WantHistories {
		answer.Histories = r.grid.historyValues()
	}
	return answer, nil
}

func unstable(step uint64, x, y, value float64) string {
	return fmt.Sprintf("step %d: the velocity at (%g, %g) is %g", step, x, y, value)
}

func frameOf(content proto.Message) *wire.Frame {
	switch content := content.(type) {
	case *wire.Hello:
		return &wire.Frame{Content: &wire.Frame_Hello{Hello: content}}
	case *wire.Bye:
		return &wire.Frame{Content: &wire.Frame_Bye{Bye: content}}
	case *wire.Error:
		return &wire.Frame{Content: &wire.Frame_Error{Error: content}}
	}
	return &wire.Frame{Content: &wire.Frame_Heartbeat{Heartbeat: &wire.Heartbeat{}}}
}
