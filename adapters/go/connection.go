package main

import (
	"bytes"
	"encoding/binary"
	"errors"
	"fmt"
	"io"
	"net"
	"os"
	"sync"
	"sync/atomic"
	"time"

	"adit/wire"

	"google.golang.org/protobuf/encoding/protowire"
	"google.golang.org/protobuf/proto"
)

// Deadlines and limits of docs/reliability.md.
const (
	version         = 2
	greeting        = 5 * time.Second
	silence         = 8 * time.Second
	beatEvery       = 500 * time.Millisecond
	frameTime       = 10 * time.Second
	leastRate       = 256 << 10 // bytes a second
	writeTime       = 10 * time.Minute
	farewellTime    = 2 * time.Second
	longestHello    = 64 << 10
	longestSetup    = 4 << 20 // lower than that of others: no files are read here
	longestRequest  = 16 << 20
	longestOfFrames = 1 << 30
)

// A client that went away, or that is no client: nobody is there to be told.
var errLost = errors.New("the client is lost")

type connection struct {
	socket   *net.TCPConn
	requests chan received
	ended    chan struct{}
	longest  uint64 // of the next request; atomic
	accepted uint64 // by the client

	writing sync.Mutex
	silent  bool // the last frame was sent
	opened  bool // the preamble was sent
}

type received struct {
	frame *wire.Frame
	err   error
}

func newConnection(socket net.Conn) *connection {
	c := &connection{socket: socket.(*net.TCPConn), requests: make(chan received), ended: make(chan struct{})}
	c.socket.SetNoDelay(true)
	c.accepted = longestHello
	return c
}

func (c *connection) accept(bytes uint64) { atomic.StoreUint64(&c.longest, bytes) }

// Preamble and hello, from both ends.
func (c *connection) greet() error {
	hello := &wire.Hello{ProtocolVersion: version, Program: "grid.go", Release: release,
		MaxFrameBytes: longestOfFrames, Computes: computes}
	if err := c.send(frameOf(hello)); err != nil {
		return err
	}
	c.socket.SetReadDeadline(time.Now().Add(greeting))
	var preamble [8]byte
	if _, err := io.ReadFull(c.socket, preamble[:]); err != nil || string(preamble[:4]) != "ADIT" {
		return errLost
	}
	c.accept(longestHello)
	frame, err := c.readFrame(greeting)
	if err != nil {
		return err
	}
	theirs := frame.GetHello()
	if theirs == nil {
		return requestFault("the first frame is not hello")
	}
	if number := binary.LittleEndian.Uint32(preamble[4:]); number != version {
		return fault{wire.Error_REFUSED, "", fmt.Sprintf("%s speaks version %d of the protocol, grid.go version %d",
			theirs.Program, number, version)}
	}
	if theirs.MaxFrameBytes < longestHello {
		return requestFault("max_frame_bytes %d is below 64 KiB", theirs.MaxFrameBytes)
	}
	if len(theirs.Challenge) > 0 {
		return fault{wire.Error_REFUSED, "", "grid.go has no secret"}
	}
	c.writing.Lock()
	c.accepted = theirs.MaxFrameBytes
	c.writing.Unlock()
	c.accept(longestSetup)
	return nil
}

// Reads requests until the connection ends. It goes on while the grid computes, so that a silence is noticed.
func (c *connection) read() {
	for {
		frame, err := c.readFrame(silence)
		if err == nil && frame.GetHeartbeat() != nil {
			continue
		}
		if err == nil && frame.GetError() != nil {
			fmt.Fprintln(os.Stderr, "the client ends the run:", frame.GetError().Message)
			err = errLost
		}
		select {
		case c.requests <- received{frame, err}:
		case <-c.ended:
			return
		}
		if err != nil {
			return
		}
	}
}

func (c *connection) next(patience time.Duration) (*wire.Frame, error) {
	timer := time.NewTimer(patience)
	defer timer.Stop()
	select {
	case r := <-c.requests:
		return r.frame, r.err
	case <-timer.C:
		return nil, requestFault("no request came for %v", patience)
	}
}

func (c *connection) readFrame(patience time.Duration) (*wire.Frame, error) {
	var header [4]byte
	c.socket.SetReadDeadline(time.Now().Add(patience))
	if _, err := io.ReadFull(c.socket, header[:1]); err != nil {
		return nil, lost(err, "no byte came for %v", patience)
	}
	begin := time.Now()
	c.socket.SetReadDeadline(begin.Add(silence))
	if _, err := io.ReadFull(c.socket, header[1:]); err != nil {
		return nil, lost(err, "a frame came too slowly")
	}
	length := uint64(binary.LittleEndian.Uint32(header[:]))
	if longest := atomic.LoadUint64(&c.longest); length > longest {
		return nil, requestFault("a frame of %d bytes, where at most %d may come", length, longest)
	}
	// The buffer grows with the bytes that have come.
	var payload bytes.Buffer
	end := begin.Add(frameTime + time.Duration(length/leastRate)*time.Second)
	for uint64(payload.Len()) < length {
		deadline := time.Now().Add(silence)
		if deadline.After(end) {
			deadline = end
		}
		c.socket.SetReadDeadline(deadline)
		part := int64(length) - int64(payload.Len())
		if part > leastRate {
			part = leastRate
		}
		if _, err := io.CopyN(&payload, c.socket, part); err != nil {
			return nil, lost(err, "a frame came too slowly")
		}
	}
	return parse(payload.Bytes())
}

func lost(err error, format string, values ...interface{}) error {
	if timeout, ok := err.(net.Error); ok && timeout.Timeout() {
		return requestFault(format, values...)
	}
	return errLost
}

// A payload is the tag, the length and the bytes of one content that is known, and nothing else.
func parse(payload []byte) (*wire.Frame, error) {
	_, kind, tag := protowire.ConsumeTag(payload)
	if tag < 0 || kind != protowire.BytesType {
		return nil, requestFault("bytes that are no frame")
	}
	if _, length := protowire.ConsumeBytes(payload[tag:]); length < 0 || tag+length != len(payload) {
		return nil, requestFault("a frame that does not hold exactly one content")
	}
	frame := &wire.Frame{}
	if err := proto.Unmarshal(payload, frame); err != nil || frame.Content == nil {
		return nil, requestFault("a frame whose content is not known")
	}
	return frame, nil
}

func (c *connection) send(frame *wire.Frame) error { return c.write(frame, false) }

func (c *connection) write(frame *wire.Frame, last bool) error {
	payload, err := proto.Marshal(frame)
	if err != nil {
		return fault{wire.Error_INTERNAL, "", err.Error()}
	}
	c.writing.Lock()
	defer c.writing.Unlock()
	if c.silent {
		return nil
	}
	if uint64(len(payload)) > c.accepted {
		return sceneFault("continuum.block", "an answer of %d bytes is longer than the coupler accepts", len(payload))
	}
	var out []byte
	if !c.opened {
		out = binary.LittleEndian.AppendUint32([]byte("ADIT"), version)
		c.opened = true
	}
	out = append(binary.LittleEndian.AppendUint32(out, uint32(len(payload))), payload...)
	c.silent = last
	c.socket.SetWriteDeadline(time.Now().Add(writeTime))
	if _, err := c.socket.Write(out); err != nil {
		return errLost
	}
	return nil
}

func (c *connection) beat() {
	heartbeat := frameOf(&wire.Heartbeat{})
	ticker := time.NewTicker(beatEvery)
	defer ticker.Stop()
	for {
		select {
		case <-ticker.C:
			c.send(heartbeat)
		case <-c.ended:
			return
		}
	}
}

// The last frame. The client closes first, else the frame might be lost on its way.
func (c *connection) farewell(content proto.Message) error {
	defer c.close()
	c.write(frameOf(content), true)
	c.socket.CloseWrite()
	close(c.ended)
	c.socket.SetReadDeadline(time.Now().Add(farewellTime))
	io.Copy(io.Discard, c.socket)
	return nil
}

func (c *connection) close() { c.socket.Close() }

func (c *connection) fail(err error) {
	told, isFault := err.(fault)
	if !isFault {
		c.writing.Lock()
		c.silent = true
		c.writing.Unlock()
		close(c.ended)
		c.close()
		return
	}
	c.farewell(&wire.Error{Kind: told.kind, Path: told.path, Message: told.message})
}
