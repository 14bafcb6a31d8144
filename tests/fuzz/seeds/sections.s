    .text
    .global _start
_start:
    LOOP body LC0 = P0;
    LOOP_BEGIN body;
    R0 = R0 + R1;
    LOOP_END body;
    JUMP.S end;
    .dw 0x0025
table:
    .dd _start, end, end - _start
    .align 8
end:
    RAISE 3;
    EXCPT 0;
    RTS;
    .section .rodata, "a"
text:
    .ascii "x\001\x41"
    .asciz "y"
    .pushsection .bss
    .space (0x40)
    .popsection
    .equ size, . - text
    .long size
